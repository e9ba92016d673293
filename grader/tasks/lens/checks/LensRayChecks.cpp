#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/checks/LensChecks.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace ticker::tasks {
namespace {

using Key = std::array<std::int64_t, 3>;

Key keyOf(const Vector3& point) {
    return {std::llround(point.x * 1e9), std::llround(point.y * 1e9), std::llround(point.z * 1e9)};
}

std::set<Key> originsOf(const LensPixel& pixel) {
    std::set<Key> keys;
    for (const LensRay& ray : pixel.rays)
        keys.insert(keyOf(ray.origin));
    return keys;
}

bool startsAtEye(const LensPixel& pixel) {
    return std::ranges::all_of(pixel.rays,
                               [](const LensRay& ray) { return ray.origin.magnitude() < 1e-7; });
}

// A finding if the rays of some pixels, but not of all, start at the eye.
std::optional<Finding> someAtEye(const LensLog& log) {
    const auto at = std::ranges::count_if(log.pixels, startsAtEye);
    const bool restDiffers = std::ranges::all_of(log.pixels, [&](const LensPixel& pixel) {
        return startsAtEye(pixel) || 2 * originsOf(pixel).size() > pixel.rays.size();
    });
    if (at == 0 || !restDiffers) return std::nullopt;
    const auto first = std::ranges::find_if(log.pixels, startsAtEye) - log.pixels.begin();
    const auto index = static_cast<int>(first);
    const raytracer::RenderSettings& settings = log.asked->settings;
    Finding finding = distributedFinding(
        kDofSharedSamples, Severity::fail,
        fmt::format("Rays from all over the aperture were expected in every pixel; in {} of {} "
                    "pixels, the first in column {}, row {}, all rays start at the eye.",
                    at, log.pixels.size(), index % settings.width,
                    index / settings.width % settings.height));
    finding.hint =
        "Every pixel draws its points of the aperture in the same way, from "
        "-settings().dofAmount to settings().dofAmount: take out what sets another size, or no "
        "lens, for a part of the picture (an if, a ?: or a factor that depends on x, y or "
        "what the pixel shows).";
    return finding;
}

Finding sharedSamples(std::size_t asked, std::size_t distinct) {
    Finding finding = distributedFinding(
        kDofSharedSamples, Severity::fail,
        fmt::format("A new point of the aperture was expected for each of the {} rays; those of a "
                    "pixel start at only {} different ones.",
                    asked, distinct));
    if (distinct > 2)
        finding.hint +=
            " If it is drawn there, the random numbers are too coarse (whole numbers perhaps).";
    return finding;
}

}  // namespace

std::optional<Finding> checkLensCounts(const LensLog& log) {
    const auto asked = static_cast<std::size_t>(log.asked->settings.dofRayCount);
    std::size_t fewest = static_cast<std::size_t>(-1);
    std::size_t fewestDistinct = fewest;
    for (const LensPixel& pixel : log.pixels) {
        fewest = std::min(fewest, pixel.rays.size());
        fewestDistinct = std::min(fewestDistinct, originsOf(pixel).size());
    }
    std::optional<Finding> finding;
    if (std::ranges::all_of(log.pixels, startsAtEye)) {
        finding = distributedFinding(
            kDofNone, Severity::fail,
            "Rays from all over the aperture were expected; every ray starts at the eye.");
    } else if (fewest < asked && !log.cut) {
        finding = distributedFinding(
            kDofTooFewRays, Severity::fail,
            fmt::format("{} rays for each pixel were expected; there are {}.", asked, fewest));
    } else if (fewestDistinct <= asked / 2) {
        finding = someAtEye(log);
        if (!finding) finding = sharedSamples(asked, fewestDistinct);
    }
    if (finding) {
        finding->evidence.emplace_back("raysExpected", static_cast<double>(asked));
        finding->evidence.emplace_back("fewestRays", static_cast<double>(fewest));
        finding->evidence.emplace_back("fewestDistinctOrigins",
                                       static_cast<double>(fewestDistinct));
    }
    return finding;
}

std::optional<Finding> checkBounces(const LensLog& log) {
    const int asked = log.asked->settings.bounces;
    for (const LensPixel& pixel : log.pixels)
        for (const LensRay& ray : pixel.rays) {
            if (ray.bounces < 0 || ray.bounces == asked) continue;
            Finding finding = distributedFinding(
                kDofWrong, Severity::fail,
                fmt::format("Rays were expected to be traced with {} bounces; they are traced with "
                            "{}.",
                            asked, ray.bounces));
            finding.hint = "Call trace(scene, ray, settings().bounces).";
            return finding;
        }
    return std::nullopt;
}

// Fifty random points do not repeat by chance.
std::optional<Finding> checkPattern(const LensLog& log) {
    std::map<int, std::pair<std::set<std::set<Key>>, std::size_t>> repetitions;
    std::size_t patterns = 0;
    for (const LensPixel& pixel : log.pixels) {
        auto& [different, pixels] = repetitions[pixel.repetition];
        ++pixels;
        if (!pixel.rays.empty() && different.insert(originsOf(pixel)).second) ++patterns;
    }
    bool oneForAll = true;
    for (const auto& [repetition, seen] : repetitions) {
        const auto& [different, pixels] = seen;
        if (different.empty() || 2 * different.size() > pixels) return std::nullopt;
        oneForAll = oneForAll && different.size() == 1;
    }
    return distributedFinding(
        kDofReusedPattern, Severity::warn,
        "New random points of the aperture were expected for every pixel; " +
            (oneForAll ? std::string{"all pixels use the same ones."}
                       : fmt::format("there are only {} patterns for {} pixels, those of a row or "
                                     "a column perhaps.",
                                     patterns, log.pixels.size())));
}

}  // namespace ticker::tasks
