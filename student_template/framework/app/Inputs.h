#ifndef RAYTRACER_APP_INPUTS_H
#define RAYTRACER_APP_INPUTS_H

#include "Options.h"

#include <raytracer/base/RenderSettings.h>

#include <cstdint>
#include <filesystem>

namespace raytracer {

[[nodiscard]] std::uint64_t freshSeed();

/// Where bump maps are that do not lie beside the scene: what the options say, else the folder
/// `assets` beside the program or above it, else in the working folder; empty if no such folder
/// exists.
/// @throws InputError if the folder that the options name is not there.
[[nodiscard]] std::filesystem::path assetsOf(const Options& options);

/// The settings with a fresh seed and one thread for each core where the options say nothing.
[[nodiscard]] RenderSettings settingsOf(const Options& options);

}  // namespace raytracer

#endif
