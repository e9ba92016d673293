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

std::size_t linesOf(const ShadowLog& log) {
    std::size_t lines = 0;
    for (const PointLog& point : log.points)
        lines += point.lines[0].size();
    return lines;
}

}  // namespace

// Of two readings that fit all other questions only one may fit a light that shines along the
// surface, where they differ most.
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

// The original's helper crowds at the centre: seen along its poles 0.904 of its rays pass within
// 0.72 radii of it. That 280 of them do has a chance of 1e-12.
std::optional<Finding> checkCloseLight(const ShadowLogs& logs, const AimVerdict& aims) {
    constexpr double kSmall = 0.72;
    constexpr std::size_t kEnough = 280;
    const double radius = raytracer::RenderSettings{}.lightSize;
    for (const ShadowLog* log : logs.closeLight) {
        const double widest = widestMiss({log});
        if (std::min(linesOf(*log), aims.distinct) < kEnough || widest > kSmall * radius) continue;
        const Vector3 way = log->scene().pointLights[0].position() - log->points[0].point.position;
        Finding finding = distributedFinding(
            kShadowLightSize, Severity::fail,
            fmt::format("Shadow rays were expected all over a light of radius {}; to one that is "
                        "{:.2f} away they pass within {:.2f} of its centre, to one farther away "
                        "they do not.",
                        radius, way.magnitude(), widest));
        finding.hint =
            "The radius is settings().lightSize whatever the distance: take out the minimum (or "
            "the factor) that has the light's distance in it.";
        finding.evidence.emplace_back("widest", widest);
        return finding;
    }
    return std::nullopt;
}

// Of the helper's rays 0.552 pass within 0.3 radii of the centre. That 44 of them do has a chance
// of 5e-12.
std::optional<Finding> checkOneRay(const ShadowLogs& logs, const AimVerdict& aims) {
    constexpr double kSmall = 0.3;
    constexpr std::size_t kEnough = 44;
    for (const ShadowLog* log : logs.oneRay) {
        const double widest = widestMiss({log});
        if (std::min(linesOf(*log), aims.distinct) < kEnough ||
            widest > kSmall * log->settings().lightSize)
            continue;
        Finding finding = distributedFinding(
            kShadowFixedSamples, Severity::warn,
            fmt::format("With {} shadow rays all is right; asked for a single one, which was "
                        "expected to go to a random place of the light, illuminate casts it to the "
                        "light's centre.",
                        raytracer::RenderSettings{}.shadowRayCount));
        finding.hint =
            "Draw a place inside of the light's ball for every ray, also where it is the only one: "
            "many pixels with one random ray each show a soft shadow with noise.";
        finding.evidence.emplace_back("widest", widest);
        return finding;
    }
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
