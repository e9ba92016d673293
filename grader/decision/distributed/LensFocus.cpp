#include <grader/decision/distributed/FindingText.h>
#include <grader/decision/distributed/LensChecks.h>
#include <grader/decision/distributed/Plots.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace ticker::decision {
namespace {

// A ray made in single precision misses its focal point by some 1e-6; every mistake that is known
// misses it by more than 1e-2.
constexpr double kFocusSlack = 2e-4;

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

Finding withHint(Finding finding, const std::string& more) {
    finding.hint += ' ' + more;
    return finding;
}

Finding explainFocus(const LensLog& log) {
    const double plane = log.asked->settings.dofFocalPlane;
    if (std::all_of(log.pixels.begin(), log.pixels.end(), areParallel))
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
        return withHint(
            focusFinding("dof.focal-plane",
                         fmt::format("All rays of a pixel were expected to meet in one point of "
                                     "the focal plane; they do not meet anywhere, some pass the "
                                     "nearest point by {:.2g}.",
                                     spread),
                         log, z),
            "Find one focal point for each pixel, before the loop over its rays.");
    if (offDistance < 10.0 * kFocusSlack)
        return focusFinding(
            "dof.focal-distance",
            fmt::format("The rays of a pixel were expected to meet at z = {:.4g}; they meet at "
                        "that distance along the pinhole ray, at z = {:.4g} to {:.4g}.",
                        plane, lowZ, highZ),
            log, lowZ);
    if (offRay > 0.02) {
        Finding finding = focusFinding(
            "dof.wrong",
            "The rays of a pixel were expected to meet on the pixel's own pinhole ray; they meet "
            "beside it.",
            log, z);
        finding.hint =
            "Find the focal point anew for each pixel, from camera.castRay(x, y): nothing of "
            "another pixel may be kept (in a static variable, say). And set the pixel (x, y) "
            "itself, not one that is counted from below or with x and y exchanged.";
        return finding;
    }
    return focusFinding("dof.focal-plane",
                        fmt::format("The rays of a pixel were expected to meet at z = {:.4g}; they "
                                    "meet at z = {:.4g} to {:.4g}.",
                                    plane, lowZ, highZ),
                        log, z);
}

}  // namespace

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

}  // namespace ticker::decision
