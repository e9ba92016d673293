#include <grader/decision/distributed/FindingText.h>
#include <grader/decision/distributed/LensChecks.h>
#include <grader/decision/distributed/Plots.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace ticker::decision {
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

}  // namespace

std::optional<Finding> checkLensCounts(const LensLog& log) {
    const auto asked = static_cast<std::size_t>(log.asked->settings.dofRayCount);
    std::size_t fewest = static_cast<std::size_t>(-1);
    std::size_t fewestDistinct = fewest;
    bool atEye = true;
    for (const LensPixel& pixel : log.pixels) {
        fewest = std::min(fewest, pixel.rays.size());
        fewestDistinct = std::min(fewestDistinct, originsOf(pixel).size());
        for (const LensRay& ray : pixel.rays)
            atEye = atEye && ray.origin.magnitude() < 1e-7;
    }
    std::optional<Finding> finding;
    if (atEye) {
        finding = distributedFinding(
            "dof.none", Severity::fail,
            "Rays from all over the aperture were expected; every ray starts at the eye.");
    } else if (fewest < asked && !log.cut) {
        finding = distributedFinding(
            "dof.too-few-rays", Severity::fail,
            fmt::format("{} rays for each pixel were expected; there are {}.", asked, fewest));
    } else if (fewestDistinct <= asked / 2) {
        finding = distributedFinding(
            "dof.shared-samples", Severity::fail,
            fmt::format("A new point of the aperture was expected for each of the {} rays; those "
                        "of a pixel start at only {} different ones.",
                        asked, fewestDistinct));
        if (fewestDistinct > 2)
            finding->hint +=
                " If it is drawn there, the random numbers are too coarse (whole numbers perhaps).";
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
                "dof.wrong", Severity::fail,
                fmt::format("Rays were expected to be traced with {} bounces; they are traced with "
                            "{}.",
                            asked, ray.bounces));
            finding.hint = "Call trace(scene, ray, settings().bounces).";
            return finding;
        }
    return std::nullopt;
}

// Fifty points that are drawn do not come again by accident.
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
        "dof.reused-pattern", Severity::warn,
        "New random points of the aperture were expected for every pixel; " +
            (oneForAll ? std::string{"all pixels use the same ones."}
                       : fmt::format("there are only {} patterns for {} pixels, those of a row or "
                                     "a column perhaps.",
                                     patterns, log.pixels.size())));
}

}  // namespace ticker::decision
