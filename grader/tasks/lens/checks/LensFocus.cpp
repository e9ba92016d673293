#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/answers/LensPlots.h>
#include <grader/tasks/lens/checks/FocusMistakes.h>
#include <grader/tasks/lens/checks/LensChecks.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ticker::tasks {
namespace {

// A finding if rays are on the right lines, but in the opposite direction.
std::optional<Finding> checkHeading(const LensLog& log) {
    std::size_t away = 0;
    for (const LensPixel& pixel : log.pixels) {
        const Vector3 focal = focalPointOf(pixel, log.asked->settings);
        away += static_cast<std::size_t>(std::ranges::count_if(pixel.rays, [&](const LensRay& ray) {
            return (focal - ray.origin).dot(ray.direction) < 0.0 &&
                   distanceFrom(ray, focal) <= kFocusSlack;
        }));
    }
    if (away == 0) return std::nullopt;
    Finding finding = distributedFinding(
        kDofWrong, Severity::fail,
        fmt::format("Every ray was expected to run from the lens to the focal point; {} of {} "
                    "leave the lens away from it and see what is behind the camera.",
                    away, log.rayCount()));
    finding.hint =
        "The direction is the focal point minus the lens point: (focalPoint - "
        "lensPoint).normalised(), for every ray, with no sign that changes.";
    finding.section = "Depth of field (T2.2), step 2";
    finding.evidence.emplace_back("raysAway", static_cast<double>(away));
    return finding;
}

double farthestFromFocus(const LensLog& log) {
    double farthest = 0.0;
    for (const LensPixel& pixel : log.pixels) {
        const Vector3 focal = focalPointOf(pixel, log.asked->settings);
        for (const LensRay& ray : pixel.rays)
            farthest = std::max(farthest, distanceFrom(ray, focal));
    }
    return farthest;
}

Finding antialiased(const LensLog& log) {
    Finding finding = distributedFinding(
        kDofAntialiased, Severity::warn,
        "All rays of a pixel were expected to meet in one point of the focal plane; they go "
        "through different places of the pixel's own square there, which is antialiasing. The "
        "picture is right, with smoother edges than the handout's.");
    finding.plots.push_back(plotFocus(log));
    return finding;
}

}  // namespace

bool staysInPixels(const LensLog& log) {
    const raytracer::RenderSettings& settings = log.asked->settings;
    const double half = halfPixel(settings.width) * settings.dofFocalPlane + 0.1 * kFocusSlack;
    const auto isInside = [&](const LensRay& ray, const Vector3& focal) {
        const double length = (focal.z - ray.origin.z) / ray.direction.z;
        const Vector3 beside = ray.origin + ray.direction * length - focal;
        return length > 0.0 && std::max(std::abs(beside.x), std::abs(beside.y)) <= half;
    };
    return log.rayCount() > 0 && std::ranges::all_of(log.pixels, [&](const LensPixel& pixel) {
               const Vector3 focal = focalPointOf(pixel, settings);
               return std::ranges::all_of(pixel.rays,
                                          [&](const LensRay& ray) { return isInside(ray, focal); });
           });
}

std::optional<Finding> checkFocus(const LensLog& log) {
    if (std::optional<Finding> away = checkHeading(log)) return away;
    const double farthest = farthestFromFocus(log);
    if (farthest <= kFocusSlack) return std::nullopt;
    if (log.mayAntialias && staysInPixels(log)) return antialiased(log);
    Finding finding = explainFocus(log);
    finding.evidence.emplace_back("farthestFromFocalPoint", farthest);
    finding.plots.push_back(plotFocus(log));
    return finding;
}

}  // namespace ticker::tasks
