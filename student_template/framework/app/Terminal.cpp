#include "Terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>
#include <cstdlib>

namespace raytracer {
namespace {

std::string_view variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::string_view() : std::string_view(value);
}

}  // namespace

Palette paletteFor(std::string_view colourTerm, std::string_view term, std::string_view noColour) {
    if (!noColour.empty() || term.empty() || term == "dumb") return Palette::text;
    if (colourTerm == "truecolor" || colourTerm == "24bit") return Palette::fullColour;
    if (term.find("direct") != std::string_view::npos) return Palette::fullColour;
    if (term.find("256") != std::string_view::npos) return Palette::colours256;
    return Palette::text;
}

Terminal terminalOnStderr() {
    Terminal terminal;
    const std::string_view term = variable("TERM");
    if (isatty(STDERR_FILENO) != 1) return terminal;
    terminal.palette = paletteFor(variable("COLORTERM"), term, variable("NO_COLOR"));
    terminal.redraws = !term.empty() && term != "dumb";
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0) {
        terminal.columns = size.ws_col;
        terminal.lines = size.ws_row;
    }
    return terminal;
}

bool terminalWantsProgress() {
    return isatty(STDERR_FILENO) == 1 && variable("NO_COLOR").empty();
}

}  // namespace raytracer
