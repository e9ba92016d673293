#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/answers/KnownColours.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/support/FindingOrder.h>

#include <algorithm>

namespace ticker::tasks {
namespace {

Finding lightsLost() {
    Finding finding = distributedFinding(
        kShadowLightsMixed, Severity::fail,
        "With one light and with three the colours are right; with eight lights each was expected "
        "to add its own light scaled by its own share, and what comes out is something else.");
    finding.hint =
        "Every light of the scene counts, however many there are: loop over scene.pointLights() "
        "to its end, and treat the last one as the first.";
    finding.section = "Soft shadows (T2.1), step 3";
    return finding;
}

}  // namespace

std::optional<Finding> checkEightLights(const ShadowLogs& logs, const AimVerdict& aims,
                                        bool fixed) {
    ShadowLogs alone{{}};
    alone.severalLights = logs.eightLights;
    if (auto finding = checkEveryLight(alone)) return finding;
    if (auto finding = checkSeveralCounts(alone, fixed)) return finding;
    if (auto finding = checkSeveralSizes(alone, aims)) return finding;
    const auto fits = [](const ShadowLog* log) { return fitsAnyReading(*log); };
    if (std::ranges::all_of(logs.eightLights, fits)) return std::nullopt;
    return lightsLost();
}

std::optional<Finding> checkEightValues(const ShadowLogs& logs, const ShadowReading& reading) {
    if (allNearKnown(logs.eightLights, reading.viewerIsEye)) return std::nullopt;
    return lightsLost();
}

}  // namespace ticker::tasks
