#include <grader/oracle/references/FloatTiff.h>
#include <grader/oracle/references/Manifest.h>
#include <grader/oracle/references/ReferenceRender.h>

#include <raytracer/base/Error.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ticker::oracle {
namespace {

using raytracer::ColourRGB;

constexpr int kTile = 8;
// 4800 tiles x 3 channels of a 640 x 480 picture at 1e-6 in all: 6.5 standard errors of a normal
// variable; a little more, since each tile's error is estimated with 192 degrees of freedom.
constexpr double kLargestZ = 7.5;
// Difference of means between two instruction sets: single precision.
constexpr double kRounding = 5e-6;
// The summed variance is known to about 1 %; the bound is ten times that.
constexpr double kVarianceOff = 0.1;
// Pictures without noise: a ray that grazes an edge may hit on one machine and miss on another.
constexpr double kPinholeDifference = 1e-3;
constexpr double kPinholeShare = 2e-3;

std::array<double, 3> channels(const ColourRGB& c) {
    return {c.r, c.g, c.b};
}

struct Stored {
    FloatPicture mean, variance, error;
};

Stored readStored(const std::filesystem::path& folder, const ReferenceScene& scene) {
    Stored stored{readTiff(fileOf(folder, scene.name, "-mean.tiff")),
                  readTiff(fileOf(folder, scene.name, "-variance.tiff")),
                  readTiff(fileOf(folder, scene.name, "-error.tiff"))};
    for (const FloatPicture* picture : {&stored.mean, &stored.variance, &stored.error})
        if (picture->width != scene.settings.imageWidth() ||
            picture->height != scene.settings.imageHeight())
            throw raytracer::InputError(fileOf(folder, scene.name, "-mean.tiff").string(), 0,
                                        "the files of a reference must have its scene's size");
    return stored;
}

double zOfTile(const Moments& fresh, const Stored& stored, int left, int top, std::size_t channel) {
    double difference = 0.0;
    double variance = 0.0;
    int pixels = 0;
    for (int y = top; y < std::min(top + kTile, fresh.height); ++y) {
        for (int x = left; x < std::min(left + kTile, fresh.width); ++x) {
            const auto i = static_cast<std::size_t>(y * fresh.width + x);
            difference +=
                channels(fresh.mean[i])[channel] - channels(stored.mean.pixels[i])[channel];
            variance +=
                channels(fresh.meanError[i])[channel] + channels(stored.error.pixels[i])[channel];
            ++pixels;
        }
    }
    // Rounding errors of neighbours may be correlated, so they add up linearly.
    const double rounding = pixels * kRounding;
    return std::abs(difference) / std::sqrt(variance + rounding * rounding);
}

double largestZ(const Moments& fresh, const Stored& stored) {
    double largest = 0.0;
    for (int top = 0; top < fresh.height; top += kTile)
        for (int left = 0; left < fresh.width; left += kTile)
            for (std::size_t channel = 0; channel < 3; ++channel)
                largest = std::max(largest, zOfTile(fresh, stored, left, top, channel));
    return largest;
}

double varianceRatio(const Moments& fresh, const Stored& stored) {
    double now = 0.0;
    double then = 0.0;
    for (std::size_t i = 0; i < fresh.covariance.size(); ++i) {
        const Covariance& c = fresh.covariance[i];
        const ColourRGB& v = stored.variance.pixels[i];
        now += c.rr + c.gg + c.bb;
        then += v.r + v.g + v.b;
    }
    return then > 0.0 ? now / then : (now > 0.0 ? INFINITY : 1.0);
}

double shareOfDifferentPixels(const Moments& fresh, const Stored& stored) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < fresh.mean.size(); ++i) {
        const ColourRGB off = fresh.mean[i] - stored.mean.pixels[i];
        const double largest = std::max({std::abs(off.r), std::abs(off.g), std::abs(off.b)});
        if (!(largest <= kPinholeDifference)) ++different;
    }
    return static_cast<double>(different) / static_cast<double>(fresh.mean.size());
}

ReferenceCheck checkOne(const std::filesystem::path& folder, const ReferenceScene& scene,
                        const Manifest& manifest, const Moments& fresh) {
    const Stored stored = readStored(folder, scene);
    ReferenceCheck check;
    check.scene = scene.name;
    const auto entry = manifest.find(scene.name);
    check.sceneChanged =
        entry == manifest.end() || entry->second.sceneHash != sceneHash(scene.scene);
    if (scene.pinhole) {
        const double share = shareOfDifferentPixels(fresh, stored);
        check.passed = share <= kPinholeShare;
        check.message = fmt::format("{}: {:.3f} % of the pixels differ", scene.name, 100.0 * share);
    } else {
        check.largestZ = largestZ(fresh, stored);
        check.varianceRatio = varianceRatio(fresh, stored);
        check.passed =
            check.largestZ <= kLargestZ && std::abs(check.varianceRatio - 1.0) <= kVarianceOff;
        check.message = fmt::format("{}: largest z of a tile {:.1f}, variance x {:.3f}", scene.name,
                                    check.largestZ, check.varianceRatio);
    }
    if (check.sceneChanged) check.message += "; the scene is not the one of the manifest";
    if (!check.passed) check.message += "; the reference has drifted";
    return check;
}

}  // namespace

std::vector<ReferenceCheck> checkReferences(const std::filesystem::path& folder,
                                            const std::vector<ReferenceScene>& scenes,
                                            const ReferenceOptions& options,
                                            const ReferenceListener& listener) {
    const Manifest manifest = readManifest(folder);
    const ReferenceClock clock{scenes, listener};
    std::vector<ReferenceCheck> checks;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        clock.tell(i);
        const Moments fresh = momentsOf(scenes[i], options.rms, options.seed + i);
        if (interrupted(scenes[i])) break;
        checks.push_back(checkOne(folder, scenes[i], manifest, fresh));
    }
    clock.tell(scenes.size());
    return checks;
}

}  // namespace ticker::oracle
