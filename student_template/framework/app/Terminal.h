#ifndef RAYTRACER_APP_TERMINAL_H
#define RAYTRACER_APP_TERMINAL_H

#include <string_view>

namespace raytracer {

/// Ways to show a picture in a terminal.
enum class Palette {
    fullColour,  ///< 24 bits for each cell
    colours256,  ///< the colour cube of xterm
    text         ///< characters of different darkness
};

/// Properties of the terminal behind stderr.
struct Terminal {
    Palette palette = Palette::text;
    bool redraws = false;  ///< the cursor can move up; false for files and pipes
    int columns = 80;
    int lines = 24;
};

/// The palette according to environment variables; unset ones are empty.
/// @param colourTerm  COLORTERM
/// @param term        TERM
/// @param noColour    NO_COLOR, see https://no-color.org: any value but the empty one counts
[[nodiscard]] Palette paletteFor(std::string_view colourTerm, std::string_view term,
                                 std::string_view noColour);

/// Determined from the environment and the system.
[[nodiscard]] Terminal terminalOnStderr();

/// True if a progress bar should be drawn: stderr is a terminal and NO_COLOR is not set.
[[nodiscard]] bool terminalWantsProgress();

}  // namespace raytracer

#endif
