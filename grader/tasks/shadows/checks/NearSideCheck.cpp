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

// Only the line of a sample is visible, so the readings with each sample's distance allow every
// place on it, the near end as well. Samples that lie elsewhere do not all fit that end: some
// hundred rays arrive, and each has its light within a few thousandths where two ends of a chord
// differ by a tenth and more.
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
