#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/answers/KnownColours.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/support/FindingOrder.h>

#include <algorithm>

namespace ticker::tasks {
namespace {

// One ray of ten that arrives adds a tenth of the light.
constexpr double kSomeLight = 0.05;

bool isLit(const PointLog& point, const ShadowLog& log) {
    const ColourRGB ambient = ambientPart(point, log.scene());
    const ColourRGB full = inFullLight(point, log.scene()) - ambient;
    return point.zones[0] == Zone::umbra && !near(point.colour, ambient, full * kSomeLight);
}

}  // namespace

std::optional<Finding> checkContact(const ShadowLogs& logs) {
    for (const ShadowLog* log : logs.contact) {
        const auto lit = std::ranges::count_if(
            log->points, [&](const PointLog& point) { return isLit(point, *log); });
        if (lit == 0) continue;
        Finding finding =
            distributedFinding(kShadowWrong, Severity::fail,
                               "Where a ball rests on the floor full shadow was expected beside "
                               "the place where they touch; there is more than the ambient light, "
                               "although the ball is less than a tenth of a unit away.");
        finding.hint =
            "A hit before the light stops the ray however near it is: compare its distance with "
            "that of the target alone, not with a least distance as well. Against shadow acne "
            "start at P + N * kShadowBias, no farther off the surface. Where no ray arrives only "
            "the ambient light is left: leave no least share, as in std::max(0.1, share).";
        finding.section = "Soft shadows (T2.1), step 2";
        finding.evidence.emplace_back("litPoints", static_cast<double>(lit));
        finding.evidence.emplace_back("points", static_cast<double>(log->points.size()));
        return finding;
    }
    return std::nullopt;
}

}  // namespace ticker::tasks
