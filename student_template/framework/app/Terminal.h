#ifndef RAYTRACER_APP_TERMINAL_H
#define RAYTRACER_APP_TERMINAL_H

#include <string_view>

namespace raytracer {

/// How a terminal can show a picture.
enum class Palette {
    fullColour,  ///< 24 bits for each cell
    colours256,  ///< the colour cube of xterm
    text         ///< letters of different blackness
};

/// What stderr leads to.
struct Terminal {
    Palette palette = Palette::text;
    bool redraws = false;  ///< understands that the cursor goes up; false for files and pipes
    int columns = 80;
    int lines = 24;
};

/// What the environment's variables say; unset ones are empty.
/// @param colourTerm  COLORTERM
/// @param term        TERM
/// @param noColour    NO_COLOR, see https://no-color.org: anything but empty counts
[[nodiscard]] Palette paletteFor(std::string_view colourTerm, std::string_view term,
                                 std::string_view noColour);

/// The terminal behind stderr, from the environment and the system.
[[nodiscard]] Terminal terminalOnStderr();

/// True where a progress bar is welcome: stderr is a terminal and NO_COLOR is not set.
[[nodiscard]] bool terminalWantsProgress();

}  // namespace raytracer

#endif
