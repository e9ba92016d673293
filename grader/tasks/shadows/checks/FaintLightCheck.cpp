#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/answers/KnownColours.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/shadows/checks/ShadowRayCounts.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ticker::tasks {
namespace {

/// N.L
double facingOf(const ShadowLog& log) {
    const Vector3 towards = log.scene().pointLights[0].position() - log.points[0].point.position;
    return log.points[0].point.normal.dot(towards.normalised());
}

Finding lightLost(const ShadowLog& log, std::size_t rays, std::size_t asked) {
    constexpr double kGrazing = 0.2;
    const double facing = facingOf(log);
    Finding finding = distributedFinding(
        rays < asked ? kShadowTooFewRays : kShadowWrong, Severity::fail,
        facing < kGrazing
            ? fmt::format("A light that shines along the surface (N.L = {:.2f}) was expected to "
                          "light it by its formula; it adds something else.",
                          facing)
            : std::string{"A light of which less than 0.01 arrives was expected to add that; it "
                          "adds something else."});
    finding.hint =
        "A light is left out only where it adds nothing at all (N.L <= 0). Take out limits such as "
        "if (brightness < 0.01) continue and factors that fade it out: several faint lights add up "
        "to what can be seen.";
    finding.section = "Soft shadows (T2.1), step 3";
    if (rays < asked) finding.evidence.emplace_back("fewestRays", static_cast<double>(rays));
    finding.evidence.emplace_back("facing", facing);
    return finding;
}

}  // namespace

// Asks for any reading, not for the one that was found before: of two readings that fit all other
// questions only one may fit a light that shines along the surface, where they differ most.
std::optional<Finding> checkFaintLight(const ShadowLogs& logs) {
    for (const ShadowLog* log : logs.faintLight) {
        const auto asked = static_cast<std::size_t>(log->settings().shadowRayCount);
        const std::size_t fewest = countRays({log}).fewest;
        if (fewest < asked || !fitsAnyReading(*log)) return lightLost(*log, fewest, asked);
    }
    return std::nullopt;
}

std::optional<Finding> checkFaintValues(const ShadowLogs& logs, const ShadowReading& reading) {
    for (const ShadowLog* log : logs.faintLight)
        if (!allNearKnown({log}, reading.viewerIsEye)) return lightLost(*log, 0, 0);
    return std::nullopt;
}

std::optional<Finding> checkBackSide(const ShadowLogs& logs) {
    constexpr double kSlack = 0.02;
    for (const ShadowLog* log : logs.backSide) {
        const auto isDark = [&](const PointLog& point) {
            const ColourRGB ambient = ambientPart(point, log->scene());
            return near(point.colour, ambient, ambient * kSlack);
        };
        if (std::ranges::all_of(log->points, isDark)) continue;
        Finding finding = distributedFinding(
            kShadowWrong, Severity::fail,
            "A light behind the surface (N.L below 0) was expected to add nothing, even to a "
            "viewer who is behind it, too; it lights the surface there.");
        finding.hint =
            "Take N as it is: do not turn it to the viewer or to the light, and do not take the "
            "absolute value of N.L. The diffuse term has max(0, N.L).";
        finding.section = "Soft shadows (T2.1), step 3";
        return finding;
    }
    return std::nullopt;
}

}  // namespace ticker::tasks
