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

/// What the user asked tick1star for.
struct Options {
    std::filesystem::path scene;   ///< -i
    std::filesystem::path image;   ///< -o
    std::filesystem::path linear;  ///< --linear; empty: none wanted
    std::filesystem::path assets;  ///< --assets; empty: to be looked for
    RenderSettings settings;       ///< `seed` and `threads` only where they were given
    std::optional<std::uint64_t> seed;
    std::optional<int> threads;
    std::optional<Pixel> trace;     ///< --trace: tell of this pixel instead of rendering
    std::filesystem::path compare;  ///< --compare; empty: with nothing
    bool normals = false;           ///< --normals: colours stand for normals
    bool preview = false;           ///< --preview
    bool quiet = false;
    bool verbose = false;
    bool showHelp = false;
    bool showVersion = false;
};

/// Reads the command line.
/// @param arguments  Without the program's name.
/// @throws InputError, without a file, that names the option and says what was expected.
[[nodiscard]] Options parseOptions(std::span<const std::string> arguments);

/// The text of --help.
[[nodiscard]] std::string usage();

}  // namespace raytracer

#endif
