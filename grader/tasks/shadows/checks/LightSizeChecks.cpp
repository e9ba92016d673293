#include <grader/result/GeneralFindings.h>
#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/shadows/checks/ShadowRayCounts.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>

namespace ticker::tasks {
namespace {

/// So many lines of right rays do not all pass within this share of the light's radius.
struct Crowd {
    double share;
    std::size_t lines;
};

// The original's helper crowds at the centre: seen along its poles, from 1.4 radii away or farther,
// 0.904 of its rays pass within 0.72 radii of it. That 280 of them do has a chance of 5e-13.
constexpr Crowd kSmallLight{0.72, 280};

// Of the helper's rays 0.552 pass within 0.3 radii of the centre. That 44 of them do has a chance
// of 5e-12.
constexpr Crowd kAtCentre{0.3, 44};

std::size_t linesOf(const ShadowLog& log) {
    std::size_t lines = 0;
    for (const PointLog& point : log.points)
        lines +=
            static_cast<std::size_t>(std::ranges::count(point.lines[0], false, &AimLine::isAdded));
    return lines;
}

bool isCrowded(const ShadowLog& log, const AimVerdict& aims, const Crowd& crowd) {
    return std::min(linesOf(log), aims.distinct) >= crowd.lines &&
           widestMiss({&log}) <= crowd.share * log.settings().lightSize;
}

Finding otherThanAsked(const ShadowLog& log, const RayCounts& counts, double widest) {
    Finding finding = distributedFinding(
        kSettingsHardCoded, Severity::warn,
        fmt::format("Asked for {} shadow rays to a light of radius {:.3g}, illuminate cast {} "
                    "within {:.3g}: {}it does not follow settings().",
                    log.settings().shadowRayCount, log.settings().lightSize, counts.fewest, widest,
                    counts.fewest > 10U ? "more than the handout's 10 are accepted, but "
                                        : "right with the handout's numbers, but "));
    finding.section = "Soft shadows (T2.1)";
    finding.evidence.emplace_back("raysAsked", static_cast<double>(log.settings().shadowRayCount));
    finding.evidence.emplace_back("raysSeen", static_cast<double>(counts.fewest));
    finding.evidence.emplace_back("lightSizeAsked", log.settings().lightSize);
    finding.evidence.emplace_back("widest", widest);
    return finding;
}

}  // namespace

std::optional<Finding> checkCloseLight(const ShadowLogs& logs, const AimVerdict& aims) {
    for (const ShadowLog* log : logs.closeLight) {
        if (!isCrowded(*log, aims, kSmallLight)) continue;
        const double widest = widestMiss({log});
        const Vector3 way = log->scene().pointLights[0].position() - log->points[0].point.position;
        Finding finding = distributedFinding(
            kShadowLightSize, Severity::fail,
            fmt::format("Shadow rays were expected all over a light of radius {}; to one that is "
                        "{:.2f} away they pass within {:.2f} of its centre, to one farther away "
                        "they do not.",
                        log->settings().lightSize, way.magnitude(), widest));
        finding.hint =
            "The radius is settings().lightSize whatever the distance: take out the minimum (or "
            "the factor) that has the light's distance in it.";
        finding.evidence.emplace_back("widest", widest);
        return finding;
    }
    return std::nullopt;
}

std::optional<Finding> checkOneRay(const ShadowLogs& logs, const AimVerdict& aims) {
    for (const ShadowLog* log : logs.oneRay) {
        if (!isCrowded(*log, aims, kAtCentre)) continue;
        Finding finding = distributedFinding(
            kShadowFixedSamples, Severity::warn,
            fmt::format("With {} shadow rays all is right; asked for a single one, which was "
                        "expected to go to a random place of the light, illuminate casts it to the "
                        "light's centre.",
                        raytracer::RenderSettings{}.shadowRayCount));
        finding.hint =
            "Draw a place inside of the light's ball for every ray, also where it is the only one: "
            "many pixels with one random ray each show a soft shadow with noise.";
        finding.evidence.emplace_back("widest", widestMiss({log}));
        return finding;
    }
    return std::nullopt;
}

std::optional<Finding> checkOtherSettings(const ShadowLogs& logs, const AimVerdict& aims) {
    for (const ShadowLog* log : logs.otherSettings) {
        const RayCounts counts = countRays({log});
        const auto asked = static_cast<std::size_t>(log->settings().shadowRayCount);
        const double widest = widestMiss({log});
        const bool tooFew = counts.fewest < asked;
        const bool tooWide = widest > log->settings().lightSize * (1.0 + 1e-6) + kLargestBias;
        const bool tooNarrow = isCrowded(*log, aims, kSmallLight);
        // Any accepted reading may fit. The one that was found with the handout's light may have
        // fitted because of its wide intervals; with a smaller light only the code's own reading
        // fits.
        const bool wrongValue = !fitsAnyReading(*log);
        if (tooFew || tooWide || tooNarrow || wrongValue)
            return otherThanAsked(*log, counts, widest);
    }
    return std::nullopt;
}

}  // namespace ticker::tasks
