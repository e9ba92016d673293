#include "Jobs.h"

#include "Canvas.h"
#include "Inputs.h"
#include "NormalPicture.h"
#include "PictureDifference.h"
#include "PixelStory.h"
#include "Preview.h"
#include "Progress.h"

#include <raytracer/base/Unfinished.h>
#include <raytracer/io/ImageWriter.h>
#include <raytracer/io/SceneReader.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>

namespace raytracer {
namespace {

namespace fs = std::filesystem;

/// Result of a render, for the file and for --compare.
struct Rendered {
    Image linear;
    ByteImage bytes;
    bool whole = true;
};

Rendered renderWatched(const Scene& scene, RenderSettings settings, Progress& progress,
                       const std::function<void(const Canvas&)>& watch) {
    Canvas canvas{settings, [&progress] { return progress.interrupted(); }};
    settings.observer = &canvas;
    settings.monitor = &progress;
    watch(canvas);
    seedRandom(settings.seed);  // for solutions that loop over the pixels themselves
    try {
        Image image = Renderer{settings}.render(scene);
        const bool whole = !progress.interrupted() || progress.done() == image.height();
        ByteImage bytes = toBytes(image);
        return {std::move(image), std::move(bytes), whole};
    } catch (const RenderStopped&) {
        return {canvas.picture(), canvas.bytes(), false};
    }
}

Rendered render(const Options& options, const Scene& scene, const RenderSettings& settings) {
    Progress progress{!options.quiet && terminalWantsProgress()};
    Preview preview{terminalOnStderr()};
    Rendered rendered =
        options.normals ? Rendered{Image{settings}, normalPicture(scene, settings)}
                        : renderWatched(scene, settings, progress, [&](const Canvas& canvas) {
                              if (options.preview && preview.redraws())
                                  progress.drawAbove([&] { return preview.frame(canvas.bytes()); });
                          });
    progress.drawAbove(nullptr);
    if (options.preview) std::fputs(preview.frame(rendered.bytes).c_str(), stderr);
    return rendered;
}

/// "out.png" -> "out-difference.png"
fs::path differenceFileOf(const fs::path& image) {
    return image.parent_path() / (image.stem() += "-difference.png");
}

void compare(const ByteImage& picture, const ByteImage& other, const Options& options) {
    const PictureDifference difference = differenceOf(picture, other, options.compare.string());
    const fs::path file = differenceFileOf(options.image);
    writePng(difference.picture, file);
    std::cout << difference.inWords() << '\n'
              << "drawn four times as strong in " << file.string() << '\n';
}

/// Lists the stubs that are still there, for the option that the scene belongs to. One option is
/// enough, so the other one is not mentioned.
void remindOfStubs(const SceneDescription& scene) {
    const bool bumpy = std::any_of(scene.spheres.begin(), scene.spheres.end(),
                                   [](const auto& sphere) { return sphere.heightMap != nullptr; });
    const std::vector<std::string_view> tasks =
        bumpy ? std::vector<std::string_view>{"T1"}
              : std::vector<std::string_view>{"T2.1", "T2.2", "M1", "M2", "M3.1", "M3.2", "M4"};
    for (const std::string_view task : tasks)
        if (isUnfinished(task)) std::cerr << unfinishedRemark(task) << '\n';
}

}  // namespace

ExitCode renderPicture(const Options& options) {
    checkWritable(options.image);
    if (!options.linear.empty()) checkWritable(options.linear);
    const ByteImage other = options.compare.empty() ? ByteImage{} : readImage(options.compare);
    const SceneDescription description = readScene(options.scene, assetsOf(options));

    const auto start = std::chrono::steady_clock::now();
    const RenderSettings settings = settingsOf(options);
    if (options.verbose)
        std::cerr << "seed " << settings.seed << ", " << settings.threads << " threads\n";
    const Rendered rendered = render(options, Scene{description}, settings);
    writePng(rendered.bytes, options.image);
    if (!options.linear.empty()) writePfm(rendered.linear, options.linear);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    if (options.verbose) std::cerr << "rendered in " << seconds.count() << " s\n";
    if (!options.quiet) remindOfStubs(description);
    if (!options.compare.empty()) compare(rendered.bytes, other, options);

    if (rendered.whole) return ExitCode::success;
    std::cerr << "\ninterrupted: " << options.image.string() << " holds the rows that were done\n";
    return ExitCode::interrupted;
}

ExitCode tellOfPixel(const Options& options) {
    PixelLog log;
    const SceneDescription description = readScene(options.scene, assetsOf(options));
    const Scene scene{description, &log};
    RenderSettings settings = settingsOf(options);
    settings.threads = 1;
    settings.region = {options.trace->x, options.trace->y, 1, 1};
    settings.observer = &log;
    seedRandom(settings.seed);
    static_cast<void>(Renderer{settings}.render(scene));
    std::cout << "pixel (" << options.trace->x << ", " << options.trace->y << ") of "
              << settings.width << "x" << settings.height << ", seed " << settings.seed << '\n'
              << storyOf(log, scene, options.verbose);
    if (!options.quiet) remindOfStubs(description);
    return ExitCode::success;
}

}  // namespace raytracer
