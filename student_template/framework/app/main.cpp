#include "Options.h"
#include "Progress.h"

#include <raytracer/base/Error.h>
#include <raytracer/io/ImageWriter.h>
#include <raytracer/io/SceneReader.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <random>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace raytracer {
namespace {

namespace fs = std::filesystem;

std::uint64_t freshSeed() {
    std::random_device device;
    return std::uint64_t{device()} << 32U | device();
}

/// The folder `assets` beside the program or above it, else the one in the working folder.
fs::path findAssets() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    for (fs::path folder = program.parent_path(); !folder.empty(); folder = folder.parent_path()) {
        if (fs::is_directory(folder / "assets", error)) return folder / "assets";
        if (folder == folder.root_path()) break;
    }
    return fs::is_directory("assets", error) ? fs::path("assets") : fs::path();
}

fs::path assetsOf(const Options& options) {
    if (options.assets.empty()) return findAssets();
    std::error_code error;
    if (!fs::is_directory(options.assets, error))
        throw InputError(options.assets.string(), 0, "--assets: there is no such folder");
    return options.assets;
}

RenderSettings settingsOf(const Options& options, RenderMonitor& monitor) {
    RenderSettings settings = options.settings;
    settings.seed = options.seed ? *options.seed : freshSeed();
    settings.threads = options.threads
                           ? *options.threads
                           : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    settings.monitor = &monitor;
    return settings;
}

void writeResults(const Image& image, const Options& options) {
    writePng(image, options.image);
    if (!options.linear.empty()) writePfm(image, options.linear);
}

ExitCode renderScene(const Options& options) {
    checkWritable(options.image);
    if (!options.linear.empty()) checkWritable(options.linear);
    const Scene scene{readScene(options.scene, assetsOf(options))};

    const auto start = std::chrono::steady_clock::now();
    Progress progress{!options.quiet && terminalWantsProgress()};
    const RenderSettings settings = settingsOf(options, progress);
    if (options.verbose)
        std::cerr << "seed " << settings.seed << ", " << settings.threads << " threads\n";
    seedRandom(settings.seed);  // for solutions that loop over the pixels by themselves
    const Image image = Renderer{settings}.render(scene);
    writeResults(image, options);

    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    if (options.verbose) std::cerr << "rendered in " << seconds.count() << " s\n";
    if (!progress.interrupted() || progress.done() == image.height()) return ExitCode::success;
    std::cerr << "\ninterrupted: " << options.image.string() << " holds the rows that were done\n";
    return ExitCode::interrupted;
}

ExitCode run(const std::vector<std::string>& arguments) {
    const Options options = parseOptions(arguments);
    if (options.showHelp) {
        std::cout << usage();
        return ExitCode::success;
    }
    if (options.showVersion) {
        std::cout << "tick1star " << TICK1STAR_VERSION << '\n';
        return ExitCode::success;
    }
    return renderScene(options);
}

}  // namespace
}  // namespace raytracer

int main(int argc, char* argv[]) {
    using namespace raytracer;
    try {
        return toInt(run({argv + std::min(argc, 1), argv + argc}));
    } catch (const Error& error) {
        std::cerr << "tick1star: " << error.what() << '\n';
        return toInt(error.exitCode());
    } catch (const std::exception& error) {
        std::cerr << "tick1star: " << error.what() << '\n';
        return toInt(ExitCode::notGradable);
    }
}
