#ifndef RAYTRACER_IO_PATHOF_H
#define RAYTRACER_IO_PATHOF_H

#include <filesystem>
#include <string>
#include <string_view>

namespace raytracer {

/// Converts UTF-8 text to a path, the same on every system. On Windows, the encoding that a path
/// expects of `char` depends on the compiler's library.
[[nodiscard]] inline std::filesystem::path pathOf(std::string_view text) {
    return std::filesystem::path{std::u8string{text.begin(), text.end()}};
}

}  // namespace raytracer

#endif
