#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/checks/LensChecks.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

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

bool isFromEye(const LensRay& ray) {
    return ray.origin.magnitude() < 1e-7;
}

bool startsAtEye(const LensPixel& pixel) {
    return !pixel.rays.empty() && std::ranges::all_of(pixel.rays, isFromEye);
}

// A finding if the rays of some pixels, but not of all, start at the eye.
std::optional<Finding> someAtEye(const LensLog& log) {
    const auto at = std::ranges::count_if(log.pixels, startsAtEye);
    const bool restDiffers = std::ranges::all_of(log.pixels, [&](const LensPixel& pixel) {
        return startsAtEye(pixel) || 2 * originsOf(pixel).size() > pixel.rays.size();
    });
    if (at == 0 || !restDiffers) return std::nullopt;
    const auto first = std::ranges::find_if(log.pixels, startsAtEye) - log.pixels.begin();
    Finding finding = distributedFinding(
        kDofSharedSamples, Severity::fail,
        fmt::format("Rays from all over the aperture were expected in every pixel; in {} of {} "
                    "pixels, the first in {}, all rays start at the eye.",
                    at, log.pixels.size(), placeOf(log, first)));
    finding.hint =
        "Every pixel draws its points of the aperture in the same way, from "
        "-settings().dofAmount to settings().dofAmount: take out what sets another size, or no "
        "lens, for a part of the picture (an if, a ?: or a factor that depends on x, y or "
        "what the pixel shows).";
    return finding;
}

Finding tooFewRays(const LensLog& log, std::size_t asked) {
    const auto isPoor = [&](const LensPixel& pixel) { return pixel.rays.size() < asked; };
    const auto count = [](const LensPixel& pixel) { return pixel.rays.size(); };
    const auto poor = std::ranges::count_if(log.pixels, isPoor);
    const auto first = std::ranges::find_if(log.pixels, isPoor) - log.pixels.begin();
    std::size_t most = 0;
    for (const LensPixel& pixel : log.pixels)
        if (isPoor(pixel)) most = std::max(most, count(pixel));
    const std::size_t fewest = std::ranges::min(log.pixels, {}, count).rays.size();
    std::string seen = fmt::format("there {} {}", most == 1 ? "is" : "are", fewest);
    if (most > fewest) seen += fmt::format(" to {}", most);
    const bool some = static_cast<std::size_t>(poor) < log.pixels.size();
    if (some)
        seen = fmt::format("for {} of {} pixels, the first in {}, ", poor, log.pixels.size(),
                           placeOf(log, first)) +
               seen;
    Finding finding =
        distributedFinding(kDofTooFewRays, Severity::fail,
                           fmt::format("{} rays for each pixel were expected; {}.", asked, seen));
    if (some)
        finding.hint +=
            " Do not leave the loop early and do not skip it for some pixels (background, nearly "
            "sharp, calm colours).";
    return finding;
}

// A finding if a ray straight from the eye takes the place of a lens ray in every pixel. It is
// accepted in addition to `asked` lens rays, and as part of a pattern of many points that contains
// the eye. Random points on a grid coincide with the eye now and then. Among 50 points on a grid of
// 101 by 101 the chance is 0.005, so that a single pixel proves nothing; for all of twelve pixels
// it is 1e-28.
std::optional<Finding> eyeAmongRays(const LensLog& log, std::size_t asked) {
    constexpr std::size_t kEnoughPixels = 12;
    if (log.pixels.size() < kEnoughPixels) return std::nullopt;
    const auto fromEye = [](const LensPixel& pixel) {
        return static_cast<std::size_t>(std::ranges::count_if(pixel.rays, isFromEye));
    };
    const bool inEveryPixel = std::ranges::all_of(log.pixels, [&](const LensPixel& pixel) {
        const std::size_t straight = fromEye(pixel);
        return straight > 0 && pixel.rays.size() - straight < asked;
    });
    if (!inEveryPixel || log.cut || checkPattern(log)) return std::nullopt;
    const LensPixel& first = log.pixels.front();
    Finding finding = distributedFinding(
        kDofTooFewRays, Severity::fail,
        fmt::format("{} rays from random points of the aperture were expected for each pixel; in "
                    "every pixel {} of the {} rays starts exactly at the eye.",
                    asked, fromEye(first), first.rays.size()));
    finding.hint =
        "Every ray of the loop starts at a random point of the aperture, the first and the last as "
        "well. The pinhole ray only finds the focal point: take its colour out of the sum, and "
        "cast settings().dofRayCount rays from the lens.";
    return finding;
}

Finding sharedSamples(std::size_t asked, std::size_t distinct) {
    Finding finding = distributedFinding(
        kDofSharedSamples, Severity::fail,
        fmt::format("A new point of the aperture was expected for each of the {} rays; the number "
                    "of different points at which those of a pixel start is {}.",
                    asked, distinct));
    if (distinct > 2)
        finding.hint +=
            " If it is drawn there, the random numbers are too coarse (whole numbers perhaps).";
    return finding;
}

// The bounces of a pixel's rays one after the other, around the first wrong number.
std::string bouncesOf(const LensPixel& pixel, int asked) {
    constexpr std::ptrdiff_t kShown = 5;
    std::vector<int> bounces;
    for (const LensRay& ray : pixel.rays)
        if (ray.bounces >= 0) bounces.push_back(ray.bounces);
    const auto wrong =
        std::ranges::find_if(bounces, [&](int one) { return one != asked; }) - bounces.begin();
    const auto begin = bounces.begin() + (wrong < kShown ? 0 : wrong - 1);
    const auto end = begin + std::min<std::ptrdiff_t>(kShown, bounces.end() - begin);
    return fmt::format("{}{}{}", begin == bounces.begin() ? "" : "..., ",
                       fmt::join(begin, end, ", "), end == bounces.end() ? "" : " and so on");
}

}  // namespace

std::string placeOf(const LensLog& log, std::ptrdiff_t pixel) {
    const raytracer::RenderSettings& settings = log.asked->settings;
    const auto index = static_cast<int>(pixel);
    return fmt::format("column {}, row {}", index % settings.width,
                       index / settings.width % settings.height);
}

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
        finding = tooFewRays(log, asked);
    } else if (fewestDistinct <= asked / 2) {
        finding = someAtEye(log);
        if (!finding) finding = sharedSamples(asked, fewestDistinct);
    } else {
        finding = eyeAmongRays(log, asked);
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
    const auto isWrong = [&](const LensRay& ray) {
        return ray.bounces >= 0 && ray.bounces != asked;
    };
    const auto first = std::ranges::find_if(log.pixels, [&](const LensPixel& pixel) {
        return std::ranges::any_of(pixel.rays, isWrong);
    });
    if (first == log.pixels.end()) return std::nullopt;
    const int wrong = std::ranges::find_if(first->rays, isWrong)->bounces;
    const bool isSame = std::ranges::all_of(log.pixels, [&](const LensPixel& pixel) {
        return std::ranges::all_of(pixel.rays, [&](const LensRay& ray) {
            return ray.bounces < 0 || ray.bounces == wrong;
        });
    });
    std::string seen = fmt::format("they are traced with {}", wrong);
    if (!isSame)
        seen = fmt::format("in {} they are traced with {}",
                           placeOf(log, first - log.pixels.begin()), bouncesOf(*first, asked));
    Finding finding = distributedFinding(
        kDofWrong, Severity::fail,
        fmt::format("Rays were expected to be traced with {} bounces; {}.", asked, seen));
    finding.hint = "Call trace(scene, ray, settings().bounces).";
    if (!isSame)
        finding.hint +=
            " Every ray of every pixel has that number: it is not counted down from "
            "ray to ray.";
    return finding;
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
