#include "Inputs.h"

#include "System.h"

#include <raytracer/base/Error.h>

#include <algorithm>
#include <random>
#include <system_error>
#include <thread>

namespace raytracer {
namespace {

namespace fs = std::filesystem;

/// Finds the folder `assets` beside the program or above it, else in the working folder.
fs::path findAssets() {
    std::error_code error;
    const fs::path program = programFile();
    for (fs::path folder = program.parent_path(); !folder.empty(); folder = folder.parent_path()) {
        if (fs::is_directory(folder / "assets", error)) return folder / "assets";
        if (folder == folder.root_path()) break;
    }
    return fs::is_directory("assets", error) ? fs::path("assets") : fs::path();
}

}  // namespace

std::uint64_t freshSeed() {
    std::random_device device;
    return std::uint64_t{device()} << 32U | device();
}

fs::path assetsOf(const Options& options) {
    if (options.assets.empty()) return findAssets();
    std::error_code error;
    if (!fs::is_directory(options.assets, error))
        throw InputError(options.assets.string(), 0, "--assets: there is no such folder");
    return options.assets;
}

RenderSettings settingsOf(const Options& options) {
    RenderSettings settings = options.settings;
    settings.seed = options.seed ? *options.seed : freshSeed();
    settings.threads = options.threads
                           ? *options.threads
                           : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    return settings;
}

}  // namespace raytracer
