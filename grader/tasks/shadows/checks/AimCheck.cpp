#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/answers/AimNormal.h>
#include <grader/tasks/shadows/answers/AimPlot.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <utility>

namespace ticker::tasks {
namespace {

Finding turnedWithViewer() {
    Finding finding = distributedFinding(
        kShadowNotABall, Severity::fail,
        "Shadow rays were expected to aim at the same light wherever the viewer O stands; the "
        "shape in which they aim turns with O, as a disc does that faces the viewer.");
    finding.hint =
        "A disc of light has to face the point P that is lit, not the viewer O. Better, take the "
        "whole ball: light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize.";
    return finding;
}

Finding crowdedAims(const AimShape& shape) {
    return distributedFinding(
        kShadowClustered, Severity::warn,
        std::string{"The points in the light were expected to be spread evenly; they crowd at "} +
            (shape.radius == AimShape::Radius::uniform
                 ? "its centre and its poles, as those of the original course's helper do."
                 : "two poles, since the angle from there, not its cosine, is drawn evenly."));
}

// Half a ball leans by 0.2 of the radius or more, for every accepted density. The mean of 200
// independent feet of a whole one leans by less than the bound, but for a chance of 1e-2, which
// changes words alone.
std::optional<Finding> halfAlongNormal(const ShadowLogs& logs, const AimVerdict& aims) {
    constexpr double kHalf = 0.15;
    constexpr std::size_t kEnough = 200;
    const double lean = leanToNormal(logs.farLight);
    if (aims.distinct < kEnough || std::abs(lean) < kHalf) return std::nullopt;
    Finding finding = distributedFinding(
        kShadowNotABall, Severity::fail,
        fmt::format("Shadow rays were expected to fill a ball of radius {} around the light; they "
                    "keep to one side of it, {} the surface's normal N.",
                    raytracer::RenderSettings{}.lightSize,
                    lean > 0.0 ? "that of" : "the one opposite to"));
    finding.hint =
        "Take Vector3::randomInsideUnitSphere() as it is, times settings().lightSize, whatever its "
        "sign against N: turn no offset round, leave none out, and add no N to the target. N "
        "belongs to the start of the ray, P + N * kShadowBias, and to the diffuse and the specular "
        "term.";
    finding.evidence.emplace_back("leanToNormal", lean);
    return finding;
}

std::optional<Finding> shapeOrSize(const AimVerdict& aims, double radius) {
    // If the outermost rays reach exactly as far as they should, the size is right.
    constexpr double kSameWidth = 0.02;
    const bool asWide = !aims.tooWide && !aims.huddled && std::abs(aims.widest - 1.0) < kSameWidth;
    if (aims.together)
        return distributedFinding(
            kShadowNotABall, Severity::fail,
            "A new random point of the light was expected for each shadow ray; the rays of one "
            "point all go to one side of the light, or lie along one line or in one plane (as a "
            "flat disc seen from its edge).");
    if (aims.turnsWithViewer) return turnedWithViewer();
    if (aims.offCentre || (!aims.shapeIsRight() && (!aims.scaledShape || asWide)))
        return distributedFinding(
            kShadowNotABall, Severity::fail,
            fmt::format("Shadow rays were expected to fill a ball of radius {} around the light; "
                        "where they aim has another shape{}.",
                        radius, aims.offCentre ? ", off the light's centre" : ""));
    if (aims.tooWide || !aims.shapeIsRight() || aims.huddled)
        return distributedFinding(
            kShadowLightSize, Severity::fail,
            fmt::format("Shadow rays were expected to pass within {} of the light's centre; they "
                        "fill a ball of radius {:.3g}.",
                        radius, aims.widest * radius));
    if (aims.shape && aims.shape->poles != AimShape::Poles::none) return crowdedAims(*aims.shape);
    return std::nullopt;
}

}  // namespace

std::optional<Finding> checkAims(const ShadowLogs& logs, const AimVerdict& aims) {
    if (aims.lines == 0) return std::nullopt;
    const double radius = raytracer::RenderSettings{}.lightSize;
    std::optional<Finding> finding = shapeOrSize(aims, radius);
    const bool turned = aims.together || aims.turnsWithViewer;
    if (finding && finding->id == kShadowNotABall.id && !turned)
        if (std::optional<Finding> half = halfAlongNormal(logs, aims)) finding = std::move(half);
    if (finding) {
        finding->evidence.emplace_back("widest", aims.widest * radius);
        finding->evidence.emplace_back("widestExpected", radius);
        finding->evidence.emplace_back("shareNearRim", aims.rimShare);
        finding->evidence.emplace_back("lean", aims.lean * radius);
        finding->evidence.emplace_back("lines", static_cast<double>(aims.lines));
        finding->plots.push_back(plotAims(logs.farLight, logs.oneLight));
    }
    return finding;
}

}  // namespace ticker::tasks
