#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/support/FindingOrder.h>

#include <algorithm>

namespace ticker::tasks {
namespace {

using Phong = ShadowReading::Phong;

bool fitsAll(const std::vector<const ShadowLog*>& logs, const ShadowReading& reading) {
    return std::ranges::all_of(
        logs, [&](const ShadowLog* log) { return allFit(*log, reading, ShadowArithmetic::right); });
}

}  // namespace

// Only the line of a sample is visible, so readings with each sample's distance allow every place
// on its chord of the light, and the near end as well. This check asks whether the near end alone
// fits all points. Samples elsewhere on the chord do not pass: some hundred rays arrive, the
// tolerance is a few thousandths, and the light from the two ends of a chord differs by a tenth or
// more.
std::optional<Finding> checkNearSide(const ShadowLogs& logs) {
    const std::vector<const ShadowLog*> all = logs.atHandoutSettings();
    if (std::ranges::any_of(all, &ShadowLog::cut)) return std::nullopt;
    bool fits = false;
    for (ShadowReading reading : acceptedShadowReadings()) {
        reading.nearSide =
            reading.phong == Phong::centralFalloff || reading.phong == Phong::perSample;
        if (!fitsAll(logs.oneLight, reading) || !fitsAll(all, reading)) continue;
        if (!reading.nearSide) return std::nullopt;
        fits = true;
    }
    return fits ? std::optional{nearSideFalloff()} : std::nullopt;
}

Finding nearSideFalloff() {
    return distributedFinding(
        kShadowNearSideFalloff, Severity::warn,
        "The light was expected to fall off over the distance of its centre, or of a random point "
        "in it; it falls off over the distance of the near side of its ball, which makes it "
        "brighter.");
}

}  // namespace ticker::tasks
