#include <grader/decision/distributed/FindingText.h>
#include <grader/decision/distributed/LensChecks.h>
#include <grader/decision/distributed/Plots.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>

namespace ticker::decision {
namespace {

// A ray made in single precision misses its focal point by some 1e-6; every mistake that is known
// misses it by more than 1e-2.
constexpr double kFocusSlack = 2e-4;

// Means of fifty colours in single precision.
constexpr double kMeanSlack = 3e-5;

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

bool near(const ColourRGB& a, const ColourRGB& b) {
    const double slack = kMeanSlack * (std::abs(b.r) + std::abs(b.g) + std::abs(b.b)) + 1e-9;
    return std::abs(a.r - b.r) <= slack && std::abs(a.g - b.g) <= slack &&
           std::abs(a.b - b.b) <= slack;
}

std::vector<ColourRGB> valuesOf(const LensPixel& pixel) {
    std::vector<ColourRGB> values;
    for (const LensRay& ray : pixel.rays)
        if (ray.value) values.push_back(*ray.value);
    return values;
}

ColourRGB meanOf(const ColourRGB* first, std::size_t count) {
    ColourRGB sum;
    for (std::size_t i = 0; i < count; ++i)
        sum += first[i];
    return sum / static_cast<double>(std::max<std::size_t>(count, 1));
}

// All rays, or all but an extra ray at the beginning or the end that was traced for another reason.
bool isMean(const LensPixel& pixel, std::size_t asked) {
    const std::vector<ColourRGB> values = valuesOf(pixel);
    if (values.empty()) return false;
    if (near(pixel.colour, meanOf(values.data(), values.size()))) return true;
    if (values.size() <= asked) return false;
    for (const std::size_t skipped : {std::size_t{1}, values.size() - asked}) {
        const std::size_t kept = values.size() - skipped;
        if (near(pixel.colour, meanOf(values.data(), kept)) ||
            near(pixel.colour, meanOf(values.data() + skipped, kept)))
            return true;
    }
    return false;
}

template <class Test>
bool everyPixel(const LensLog& log, const Test& test) {
    return std::all_of(log.pixels.begin(), log.pixels.end(), test);
}

// The factor between what was expected and what came, where it is the same everywhere; else 0.
double commonFactor(const LensLog& log) {
    double factor = 0.0;
    for (const LensPixel& pixel : log.pixels) {
        const std::vector<ColourRGB> values = valuesOf(pixel);
        const ColourRGB mean = meanOf(values.data(), values.size());
        const double whole = mean.r + mean.g + mean.b;
        if (!(whole > 1e-6)) continue;
        if (factor == 0.0) factor = (pixel.colour.r + pixel.colour.g + pixel.colour.b) / whole;
        if (!near(pixel.colour, mean * factor)) return 0.0;
    }
    return factor;
}

enum class Which { first, last };

bool isOneOf(const LensPixel& pixel, Which which) {
    const std::vector<ColourRGB> values = valuesOf(pixel);
    return !values.empty() &&
           near(pixel.colour, which == Which::first ? values.front() : values.back());
}

bool withinSamples(const LensPixel& pixel) {
    const std::vector<ColourRGB> values = valuesOf(pixel);
    if (values.empty()) return false;
    ColourRGB low = values.front();
    ColourRGB high = values.front();
    for (const ColourRGB& value : values) {
        low = {std::min(low.r, value.r), std::min(low.g, value.g), std::min(low.b, value.b)};
        high = {std::max(high.r, value.r), std::max(high.g, value.g), std::max(high.b, value.b)};
    }
    const ColourRGB& c = pixel.colour;
    const double slack = 1e-6;
    return c.r >= low.r - slack && c.r <= high.r + slack && c.g >= low.g - slack &&
           c.g <= high.g + slack && c.b >= low.b - slack && c.b <= high.b + slack;
}

/// The point that is nearest to all rays of a pixel (least squares), and how far they pass it.
struct Meeting {
    Vector3 point;
    double farthest = 0.0;
};

double distanceFrom(const LensRay& ray, const Vector3& point) {
    return (point - ray.origin).cross(ray.direction).magnitude();
}

Meeting meetingOf(const LensPixel& pixel) {
    // Sum over rays of (1 - d d^T) (q - o) = 0, solved by Cramer's rule.
    Vector3 rows[3];
    Vector3 right;
    for (const LensRay& ray : pixel.rays) {
        const Vector3& d = ray.direction;
        rows[0] += Vector3{1.0, 0.0, 0.0} - d * d.x;
        rows[1] += Vector3{0.0, 1.0, 0.0} - d * d.y;
        rows[2] += Vector3{0.0, 0.0, 1.0} - d * d.z;
        right += ray.origin - d * d.dot(ray.origin);
    }
    Meeting meeting;
    const double volume = rows[0].dot(rows[1].cross(rows[2]));
    const Vector3 ab = rows[1].cross(rows[2]);
    const Vector3 bc = rows[2].cross(rows[0]);
    const Vector3 ca = rows[0].cross(rows[1]);
    meeting.point = (ab * right.x + bc * right.y + ca * right.z) / volume;
    for (const LensRay& ray : pixel.rays)
        meeting.farthest = std::max(meeting.farthest, distanceFrom(ray, meeting.point));
    return meeting;
}

bool areParallel(const LensPixel& pixel) {
    return std::all_of(pixel.rays.begin(), pixel.rays.end(), [&](const LensRay& ray) {
        return ray.direction.cross(pixel.rays.front().direction).magnitude() < 1e-6;
    });
}

Finding focusFinding(const char* id, std::string seen, const LensLog& log, double z) {
    Finding finding = distributedFinding(id, Severity::fail, std::move(seen));
    finding.evidence.emplace_back("focalPlaneExpected", log.asked->settings.dofFocalPlane);
    finding.evidence.emplace_back("meetingZ", z);
    return finding;
}

Finding explainFocus(const LensLog& log) {
    const double plane = log.asked->settings.dofFocalPlane;
    if (everyPixel(log, areParallel))
        return focusFinding("dof.focal-plane",
                            "All rays of a pixel were expected to meet on the focal plane; they "
                            "are parallel and never meet.",
                            log, 0.0);
    double lowZ = 1e30;
    double highZ = -1e30;
    double offRay = 0.0;
    double offDistance = 0.0;
    double spread = 0.0;
    for (const LensPixel& pixel : log.pixels) {
        const Meeting meeting = meetingOf(pixel);
        spread = std::max(spread, meeting.farthest);
        lowZ = std::min(lowZ, meeting.point.z);
        highZ = std::max(highZ, meeting.point.z);
        offRay = std::max(offRay, meeting.point.cross(pixel.pinhole).magnitude());
        offDistance = std::max(offDistance, (meeting.point - pixel.pinhole * plane).magnitude());
    }
    const double z = 0.5 * (lowZ + highZ);
    if (spread > 10.0 * kFocusSlack)
        return focusFinding("dof.focal-plane",
                            "All rays of a pixel were expected to meet in one point of the focal "
                            "plane; they do not meet anywhere.",
                            log, z);
    if (offDistance < 10.0 * kFocusSlack)
        return focusFinding(
            "dof.focal-distance",
            fmt::format("The rays of a pixel were expected to meet at z = {:.4g}; they meet at "
                        "that distance along the pinhole ray, at z = {:.4g} to {:.4g}.",
                        plane, lowZ, highZ),
            log, lowZ);
    if (offRay > 0.02)
        return focusFinding("dof.wrong",
                            "The rays of a pixel were expected to meet on the pixel's own pinhole "
                            "ray; they meet beside it.",
                            log, z);
    return focusFinding("dof.focal-plane",
                        fmt::format("The rays of a pixel were expected to meet at z = {:.4g}; they "
                                    "meet at z = {:.4g} to {:.4g}.",
                                    plane, lowZ, highZ),
                        log, z);
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
            fmt::format("A new point of the aperture was expected for each of the {} rays; a pixel "
                        "uses {} of them.",
                        asked, fewestDistinct));
    }
    if (finding) {
        finding->evidence.emplace_back("raysExpected", static_cast<double>(asked));
        finding->evidence.emplace_back("fewestRays", static_cast<double>(fewest));
        finding->evidence.emplace_back("fewestDistinctOrigins",
                                       static_cast<double>(fewestDistinct));
    }
    return finding;
}

std::optional<Finding> checkAverage(const LensLog& log) {
    const bool traced = std::any_of(log.pixels.begin(), log.pixels.end(), [](const LensPixel& p) {
        return !p.rays.empty() && p.rays.front().value.has_value();
    });
    if (!traced || log.cut) return std::nullopt;
    const auto asked = static_cast<std::size_t>(log.asked->settings.dofRayCount);
    if (everyPixel(log, [&](const LensPixel& pixel) { return isMean(pixel, asked); }))
        return std::nullopt;
    const double factor = commonFactor(log);
    std::string seen;
    if (factor != 0.0)
        seen = fmt::format("it is {:.4g} times their mean", factor);
    else if (everyPixel(log, [](const LensPixel& p) { return isOneOf(p, Which::last); }))
        seen = "it is the colour of the last ray alone";
    else if (everyPixel(log, [](const LensPixel& p) { return isOneOf(p, Which::first); }))
        seen = "it is the colour of the first ray alone";
    else if (everyPixel(log, withinSamples))
        seen = "some rays count more than others";
    if (seen.empty())
        return distributedFinding("dof.wrong", Severity::fail,
                                  "The colour of a pixel was expected to be the mean of its rays' "
                                  "colours; it is none of the things that are known to go wrong.");
    Finding finding = distributedFinding(
        "dof.not-averaged", Severity::fail,
        "The colour of a pixel was expected to be the mean of its rays' colours; " + seen + ".");
    if (factor != 0.0) finding.evidence.emplace_back("factor", factor);
    return finding;
}

std::optional<Finding> checkFocus(const LensLog& log) {
    const raytracer::RenderSettings& settings = log.asked->settings;
    double farthest = 0.0;
    for (const LensPixel& pixel : log.pixels) {
        const Vector3 focal = focalPointOf(pixel, settings);
        for (const LensRay& ray : pixel.rays)
            farthest = std::max(farthest, distanceFrom(ray, focal));
    }
    if (farthest <= kFocusSlack) return std::nullopt;
    Finding finding = explainFocus(log);
    finding.evidence.emplace_back("farthestFromFocalPoint", farthest);
    finding.plots.push_back(plotFocus(log));
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

std::optional<Finding> checkPattern(const LensLog& log) {
    for (const LensPixel& pixel : log.pixels) {
        const auto first = std::find_if(
            log.pixels.begin(), log.pixels.end(),
            [&](const LensPixel& other) { return other.repetition == pixel.repetition; });
        if (originsOf(*first) != originsOf(pixel)) return std::nullopt;
    }
    return distributedFinding("dof.reused-pattern", Severity::warn,
                              "New random points of the aperture were expected for every pixel; "
                              "all pixels use the same ones.");
}

}  // namespace ticker::decision
