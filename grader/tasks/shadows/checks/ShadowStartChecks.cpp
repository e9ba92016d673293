#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/shadows/checks/ShadowRayCounts.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ticker::tasks {

std::optional<Finding> checkStarts(const ShadowLogs& logs) {
    double farthest = 0.0;
    double spread = 0.0;
    double fromViewer = 0.0;
    for (const ShadowLog* log : logs.atHandoutSettings())
        for (const PointLog& point : log->points)
            for (const std::vector<AimLine>& lines : point.lines)
                for (const AimLine& line : lines) {
                    farthest = std::max(farthest, biasOf(line, point));
                    spread = std::max(spread, (line.origin - lines.front().origin).magnitude());
                    fromViewer =
                        std::max(fromViewer, (line.origin - point.point.viewer).magnitude());
                }
    if (farthest <= kLargestBias) return std::nullopt;
    Finding finding = distributedFinding(
        spread > kLargestBias ? kShadowPointJittered : kShadowWrong, Severity::fail,
        fmt::format("Shadow rays were expected to start at the point that is lit (at most 0.001 "
                    "from it); they start up to {:.3g} away.",
                    farthest));
    if (spread <= kLargestBias) finding.hint = "Start the shadow rays at P + N * kShadowBias.";
    if (fromViewer <= kLargestBias) finding.hint += " O is where P is seen from: they start there.";
    finding.evidence.emplace_back("farthestStart", farthest);
    finding.evidence.emplace_back("spreadOfStarts", spread);
    return finding;
}

// A line alone does not show this: the line of a ray that starts away from the light passes the
// light, too, behind the ray's start.
std::optional<Finding> checkBackwards(const ShadowLogs& logs) {
    std::size_t rays = 0;
    std::size_t backwards = 0;
    for (const ShadowLog* log : logs.oneLight) {
        const Vector3 light = log->scene().pointLights[0].position();
        for (const PointLog& point : log->points)
            for (const AimLine& line : point.lines[0]) {
                ++rays;
                if ((light - line.origin).dot(line.direction) < 0.0) ++backwards;
            }
    }
    if (2 * backwards <= rays) return std::nullopt;
    Finding finding = distributedFinding(
        kShadowWrong, Severity::fail,
        fmt::format("Shadow rays were expected to leave towards the light; {} of {} leave in the "
                    "opposite direction, away from it.",
                    backwards, rays));
    finding.hint =
        "A ray from the point to the light has the direction target minus start: "
        "(target - start).normalised().";
    finding.section = "Soft shadows (T2.1), step 1";
    finding.evidence.emplace_back("rays", static_cast<double>(rays));
    finding.evidence.emplace_back("raysAwayFromTheLight", static_cast<double>(backwards));
    return finding;
}

}  // namespace ticker::tasks
