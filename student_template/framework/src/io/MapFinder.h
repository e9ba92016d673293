#ifndef RAYTRACER_SRC_IO_MAPFINDER_H
#define RAYTRACER_SRC_IO_MAPFINDER_H

#include <filesystem>
#include <string>
#include <vector>

namespace raytracer {

/// Finds the bump maps that a scene names, in a few folders only: scenes are untrusted input.
class MapFinder {
public:
    /// @param folders  In search order; empty paths are skipped.
    explicit MapFinder(const std::vector<std::filesystem::path>& folders);

    struct Result {
        std::filesystem::path file;  ///< empty if it was not found
        std::string problem;         ///< in that case: the reason, and what was expected
    };

    /// Searches for `name`; the first folder that has it wins.
    [[nodiscard]] Result find(const std::string& name) const;

private:
    std::vector<std::filesystem::path> folders_;
};

}  // namespace raytracer

#endif
