#ifndef RAYTRACER_APP_OPTIONS_H
#define RAYTRACER_APP_OPTIONS_H

#include <raytracer/base/RenderSettings.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace raytracer {

/// A pixel of the full frame; (0, 0) is top left.
struct Pixel {
    int x = 0;
    int y = 0;
};

/// The command line of tick1star.
struct Options {
    std::filesystem::path scene;   ///< -i
    std::filesystem::path image;   ///< -o
    std::filesystem::path linear;  ///< --linear; empty: none wanted
    std::filesystem::path assets;  ///< --assets; empty: search for the folder
    RenderSettings settings;       ///< without `seed` and `threads`, unless they were given
    std::optional<std::uint64_t> seed;
    std::optional<int> threads;
    std::optional<Pixel> trace;     ///< --trace: explain this pixel instead of rendering
    std::filesystem::path compare;  ///< --compare; empty: no comparison
    bool normals = false;           ///< --normals: show normals as colours
    bool preview = false;           ///< --preview
    bool view = false;              ///< --view
    bool quiet = false;
    bool verbose = false;
    bool showHelp = false;
    bool showVersion = false;
};

/// Parses the command line.
/// @param arguments  Without the program's name.
/// @throws InputError, without a file, that names the option and says what was expected.
[[nodiscard]] Options parseOptions(std::span<const std::string> arguments);

/// The text of --help.
[[nodiscard]] std::string usage();

}  // namespace raytracer

#endif
