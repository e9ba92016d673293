#ifndef RAYTRACER_APP_VIEW_VIEWHOME_H
#define RAYTRACER_APP_VIEW_VIEWHOME_H

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace raytracer::view {

/// Where the program was built from: what the viewer watches, and how it builds that again. CMake
/// writes one for each solution.
struct ViewHome {
    std::filesystem::path exercise;  ///< the folder that students edit
    std::filesystem::path scenes;
    std::filesystem::path build;    ///< cmake --build ...
    std::string target;             ///< ... --target ...
    std::filesystem::path program;  ///< ... which makes this
    std::string testTarget;         ///< empty: there are no tests
    std::filesystem::path tests;
    std::string cmake;
    bool hasLens = true;  ///< the exercise has lights with a size, and a lens
    std::vector<std::pair<std::string, std::string>> suites;  ///< task: the suite of its tests
};

[[nodiscard]] const ViewHome& viewHome();

}  // namespace raytracer::view

#endif
