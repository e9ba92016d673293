#include "Terminal.h"

#include "System.h"

#include <cstdlib>
#include <optional>

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
    if (!isTerminal(Stream::error)) return terminal;
    const bool isModern = term.empty() && terminalsNeedNoTerm();
    terminal.palette = isModern && variable("NO_COLOR").empty()
                           ? Palette::fullColour
                           : paletteFor(variable("COLORTERM"), term, variable("NO_COLOR"));
    terminal.redraws = isModern || (!term.empty() && term != "dumb");
    if (const std::optional<WindowSize> size = windowSize(Stream::error)) {
        terminal.columns = size->columns;
        terminal.lines = size->lines;
    }
    return terminal;
}

bool terminalWantsProgress() {
    return isTerminal(Stream::error) && variable("NO_COLOR").empty();
}

}  // namespace raytracer
