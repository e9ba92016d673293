#ifndef RAYTRACER_SRC_IO_MAPFINDER_H
#define RAYTRACER_SRC_IO_MAPFINDER_H

#include <filesystem>
#include <string>
#include <vector>

namespace raytracer {

/// Looks for the bump maps that a scene names, and never outside a few folders: scenes come from
/// strangers.
class MapFinder {
public:
    /// @param folders  In the order in which they are searched; an empty path is left out.
    explicit MapFinder(const std::vector<std::filesystem::path>& folders);

    struct Result {
        std::filesystem::path file;  ///< empty where there is none
        std::string problem;         ///< then: why, and what was expected
    };

    /// The file called `name` in the first folder that has it.
    [[nodiscard]] Result find(const std::string& name) const;

private:
    std::vector<std::filesystem::path> folders_;
};

}  // namespace raytracer

#endif
