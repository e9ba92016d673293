#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/checks/FocusMistakes.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace ticker::tasks {
namespace {

/// The point nearest to all rays of a pixel (least squares), and the rays' distance from it.
struct Meeting {
    Vector3 point;
    double farthest = 0.0;
};

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

Finding focusFinding(const FindingText& text, std::string seen, const LensLog& log, double z) {
    Finding finding = distributedFinding(text, Severity::fail, std::move(seen));
    finding.evidence.emplace_back("focalPlaneExpected", log.asked->settings.dofFocalPlane);
    finding.evidence.emplace_back("meetingZ", z);
    return finding;
}

Finding withHint(Finding finding, const std::string& more) {
    finding.hint += ' ' + more;
    return finding;
}

/// The points where the rays of all pixels meet.
struct Meetings {
    std::vector<Vector3> points;
    double lowZ = 1e30;
    double highZ = -1e30;
    double offRay = 0.0;       ///< largest distance from the pinhole ray
    double offDistance = 0.0;  ///< largest distance from the point at the focal distance along it
    double spread = 0.0;       ///< largest distance of a ray from its pixel's point
};

Meetings meetingsOf(const LensLog& log) {
    const double plane = log.asked->settings.dofFocalPlane;
    Meetings all;
    for (const LensPixel& pixel : log.pixels) {
        const Meeting meeting = meetingOf(pixel);
        const Vector3& point = meeting.point;
        all.points.push_back(point);
        all.spread = std::max(all.spread, meeting.farthest);
        all.lowZ = std::min(all.lowZ, point.z);
        all.highZ = std::max(all.highZ, point.z);
        all.offRay = std::max(all.offRay, point.cross(pixel.pinhole).magnitude());
        all.offDistance = std::max(all.offDistance, (point - pixel.pinhole * plane).magnitude());
    }
    return all;
}

/// One coordinate of the meeting points, over all pixels.
struct Coordinate {
    const char* name;
    double Vector3::*axis;
    /// Equals that of the point at the focal distance along the pinhole ray.
    bool isByLength = true;
    bool isOnPlane = true;  ///< equals that of the focal point
};

std::array<Coordinate, 3> coordinatesOf(const LensLog& log, const Meetings& meetings) {
    std::array<Coordinate, 3> all{{{"x", &Vector3::x}, {"y", &Vector3::y}, {"z", &Vector3::z}}};
    const double plane = log.asked->settings.dofFocalPlane;
    for (std::size_t i = 0; i < log.pixels.size(); ++i)
        for (Coordinate& one : all) {
            const auto is = [&](const Vector3& point) {
                return std::abs(meetings.points[i].*one.axis - point.*one.axis) <
                       10.0 * kFocusSlack;
            };
            one.isByLength = one.isByLength && is(log.pixels[i].pinhole * plane);
            one.isOnPlane = one.isOnPlane && is(focalPointOf(log.pixels[i], log.asked->settings));
        }
    return all;
}

// Explains meeting points that have some coordinates of the point at the focal distance along the
// ray.
std::optional<Finding> explainCoordinates(const LensLog& log, const Meetings& meetings) {
    std::string byLength;
    for (const Coordinate& one : coordinatesOf(log, meetings)) {
        if (!one.isByLength && !one.isOnPlane) return std::nullopt;
        if (one.isOnPlane) continue;
        byLength += (byLength.empty() ? "" : " and ") + std::string{one.name};
    }
    Finding finding = focusFinding(
        kDofWrong,
        fmt::format("The rays of a pixel were expected to meet where its pinhole ray has z = "
                    "{:.4g}; they meet beside that ray: {} of the meeting point is the direction's "
                    "times {:.4g}, not divided by direction.z.",
                    log.asked->settings.dofFocalPlane, byLength, log.asked->settings.dofFocalPlane),
        log, meetings.lowZ);
    finding.hint =
        "The length along the ray is dofFocalPlane / direction.z, for all three coordinates: "
        "pinholeRay.evaluateAt(settings().dofFocalPlane / pinholeRay.direction.z).";
    return finding;
}

Finding explainBeside(const LensLog& log, double z) {
    Finding finding =
        focusFinding(kDofWrong,
                     "The rays of a pixel were expected to meet on the pixel's own pinhole ray; "
                     "they meet beside it.",
                     log, z);
    finding.hint =
        "Find the focal point anew for each pixel, from camera.castRay(x, y): nothing of "
        "another pixel may be kept (in a static variable, say). And set the pixel (x, y) "
        "itself, not one that is counted from below or with x and y exchanged.";
    return finding;
}

}  // namespace

double distanceFrom(const LensRay& ray, const Vector3& point) {
    return (point - ray.origin).cross(ray.direction).magnitude();
}

bool meetInPoints(const LensLog& log) {
    return meetingsOf(log).spread <= 10.0 * kFocusSlack;
}

Finding explainFocus(const LensLog& log) {
    const double plane = log.asked->settings.dofFocalPlane;
    if (std::all_of(log.pixels.begin(), log.pixels.end(), areParallel))
        return focusFinding(kDofFocalPlane,
                            "All rays of a pixel were expected to meet on the focal plane; they "
                            "are parallel and never meet.",
                            log, 0.0);
    const Meetings meetings = meetingsOf(log);
    const double z = 0.5 * (meetings.lowZ + meetings.highZ);
    if (!meetInPoints(log))
        return withHint(
            focusFinding(kDofFocalPlane,
                         fmt::format("All rays of a pixel were expected to meet in one point of "
                                     "the focal plane; they do not meet anywhere, some pass the "
                                     "nearest point by {:.2g}.",
                                     meetings.spread),
                         log, z),
            "Find one focal point for each pixel, before the loop over its rays.");
    if (meetings.offDistance < 10.0 * kFocusSlack)
        return focusFinding(
            kDofFocalDistance,
            fmt::format("The rays of a pixel were expected to meet at z = {:.4g}; they meet at "
                        "that distance along the pinhole ray, at z = {:.4g} to {:.4g}.",
                        plane, meetings.lowZ, meetings.highZ),
            log, meetings.lowZ);
    if (std::optional<Finding> finding = explainCoordinates(log, meetings))
        return *std::move(finding);
    if (meetings.offRay > 0.02) return explainBeside(log, z);
    return focusFinding(kDofFocalPlane,
                        fmt::format("The rays of a pixel were expected to meet at z = {:.4g}; they "
                                    "meet at z = {:.4g} to {:.4g}.",
                                    plane, meetings.lowZ, meetings.highZ),
                        log, z);
}

}  // namespace ticker::tasks
