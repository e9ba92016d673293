#ifndef TICKER_TESTS_VIEW_THISPROGRAM_H
#define TICKER_TESTS_VIEW_THISPROGRAM_H

#include <student_template/framework/app/view/ViewHome.h>

#include <filesystem>
#include <string>

namespace raytracer::view {

/// The variable that names a started viewer's kit.
inline constexpr const char* kKitVariable = "TICKER_FAKE_KIT";

/// This program of tests. Started with the arguments of tick1star it is a viewer of the kit that
/// the environment names, or a worker: see ThisProgram.cpp.
[[nodiscard]] std::string thisProgram();

/// Where the kit in this folder has its parts.
[[nodiscard]] ViewHome homeIn(const std::filesystem::path& folder);

}  // namespace raytracer::view

#endif
