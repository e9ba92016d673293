#include <grader/tasks/shadows/JudgeSoftShadows.h>
#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/answers/AimPlot.h>
#include <grader/tasks/shadows/answers/ShadowCache.h>
#include <grader/tasks/shadows/checks/PartOfLight.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/shadows/checks/ShadowRayCounts.h>
#include <grader/tasks/shadows/mixed/MixedCheck.h>
#include <grader/tasks/support/Checks.h>
#include <grader/tasks/support/FindingOrder.h>
#include <grader/tasks/support/Plots.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace ticker::tasks {
namespace {

/// What the answers show. A check stores here what later checks need.
struct ShadowSeen {
    const ShadowLogs& logs;
    AimVerdict aims = {};
    std::optional<Finding> shape = {};  ///< of the points that rays aim at
    bool fixed = false;                 ///< the same aims at every point
    std::optional<ShadowReading> reading = {};
};

using Result = std::optional<Finding>;
using ShadowCheck = Check<ShadowSeen>;

bool castsNoRay(const ShadowLogs& logs) {
    for (const ShadowLog* log : logs.atHandoutSettings())
        for (const PointLog& point : log->points)
            if (point.lineCount() > 0) return false;
    return true;
}

/// Whether only one ray, to the light's centre, is visible for each point and light, although
/// points in the penumbra have a fraction of the light. Such code intersects the scene by itself,
/// and casts the visible ray for another purpose.
bool castsOnlyExtraRays(const ShadowLogs& logs) {
    constexpr double kSome = 0.02;
    const RayCounts counts = countRays(logs.atHandoutSettings());
    if (counts.mostDistinct > 1 || !counts.allCentral) return false;
    return std::ranges::any_of(logs.oneLight, [](const ShadowLog* log) {
        return std::ranges::any_of(log->points, [&](const PointLog& point) {
            const std::optional<PartOfLight> found = partOfLight(point, *log);
            return point.zones[0] == Zone::penumbra && found && found->part > kSome &&
                   found->part < 1.0 - kSome;
        });
    });
}

Result fixedSamples(ShadowSeen& seen) {
    Result finding = checkFixedSamples(seen.logs);
    seen.fixed = finding.has_value();
    return finding;
}

Result rayCounts(ShadowSeen& seen) {
    return checkRayCounts(seen.logs, seen.fixed);
}

Result failingShape(ShadowSeen& seen) {
    seen.shape = checkAims(seen.logs, seen.aims);
    return seen.shape && seen.shape->severity == Severity::fail ? seen.shape : std::nullopt;
}

Result crowding(ShadowSeen& seen) {
    const bool repeats = 2 * seen.aims.distinct < seen.aims.lines;
    const bool fails = seen.shape && seen.shape->severity == Severity::fail;
    return repeats || fails ? std::nullopt : seen.shape;
}

Result keepReading(ShadowSeen& seen, ArithmeticVerdict verdict) {
    seen.reading = verdict.reading;
    return std::move(verdict.finding);
}

Result viewer(ShadowSeen& seen) {
    if (!seen.reading || !seen.reading->viewerIsEye) return std::nullopt;
    return distributedFinding(
        kShadowViewFromEye, Severity::warn,
        "The highlights were expected as seen from O; they come out as seen from the origin of "
        "the world.");
}

Result nearSide(ShadowSeen& seen) {
    return seen.reading ? checkNearSide(seen.logs) : std::nullopt;
}

Result horizon(ShadowSeen& seen) {
    return seen.reading ? checkHorizon(seen.logs, seen.aims, *seen.reading) : std::nullopt;
}

Result contact(ShadowSeen& seen) {
    return seen.reading ? checkContact(seen.logs) : std::nullopt;
}

Result backSide(ShadowSeen& seen) {
    return seen.reading ? checkBackSide(seen.logs) : std::nullopt;
}

Result faintLight(ShadowSeen& seen) {
    return seen.reading ? checkFaintLight(seen.logs) : std::nullopt;
}

Result faintValues(ShadowSeen& seen) {
    return seen.reading ? checkFaintValues(seen.logs, *seen.reading) : std::nullopt;
}

Result eightLights(ShadowSeen& seen) {
    return seen.reading ? checkEightLights(seen.logs, seen.aims, seen.fixed) : std::nullopt;
}

Result eightValues(ShadowSeen& seen) {
    return seen.reading ? checkEightValues(seen.logs, *seen.reading) : std::nullopt;
}

template <bool RaysSeen>
Result knownScenes(ShadowSeen& seen) {
    return seen.reading ? checkKnownScenes(seen.logs, *seen.reading, RaysSeen) : std::nullopt;
}

template <bool RaysSeen>
Result manyRays(ShadowSeen& seen) {
    return seen.reading ? checkManyRays(seen.logs, *seen.reading, RaysSeen) : std::nullopt;
}

template <bool RaysSeen>
Result mixed(ShadowSeen& seen) {
    return seen.reading ? checkMixed(seen.logs.mixed, *seen.reading, RaysSeen) : std::nullopt;
}

// Code with a hard-coded light size is left out: `otherSettings` reports it.
Result mixedNear(ShadowSeen& seen) {
    if (!seen.reading || checkOtherSettings(seen.logs, seen.aims)) return std::nullopt;
    return checkMixed(seen.logs.mixedNear, *seen.reading, true);
}

Result closeLight(ShadowSeen& seen) {
    return checkCloseLight(seen.logs, seen.aims);
}

Result oneRay(ShadowSeen& seen) {
    return checkOneRay(seen.logs, seen.aims);
}

Result oddCount(ShadowSeen& seen) {
    return seen.reading ? checkOddCount(seen.logs) : std::nullopt;
}

Result otherSettings(ShadowSeen& seen) {
    return seen.reading ? checkOtherSettings(seen.logs, seen.aims) : std::nullopt;
}

/// Where the rays start and where they aim. A new check of T2.1: a row here or in checksOfColours
/// with its function, and a row in ShadowFindings.h.
std::vector<ShadowCheck> checksOfAims() {
    return std::vector<ShadowCheck>{
        // These rays go elsewhere than to the light; the other checks do not apply to them.
        {.run = [](ShadowSeen& seen) { return checkBackwards(seen.logs); }, .hides = {Hides{}}},
        {.run = fixedSamples},
        // Rays that all go to the centre have fixed aims, but that is not the fault.
        {.run = rayCounts, .hides = {{&kShadowHard, &kShadowFixedSamples}}},
        // Rays that start all around the point and go to the centre are not a hard shadow. Rays
        // that start elsewhere miss the light by more, and meet other objects: all this follows
        // from their start.
        {.run = [](ShadowSeen& seen) { return checkStarts(seen.logs); },
         .hides = {{nullptr, &kShadowHard}, {&kShadowWrong, nullptr}}},
        {.run = [](ShadowSeen& seen) { return checkSeveralCounts(seen.logs, seen.fixed); },
         .after = {{rayCounts}}},
        {.run = [](ShadowSeen& seen) { return checkSmallPool(seen.aims); },
         .after = {{rayCounts}, {fixedSamples}}},
        {.run = [](ShadowSeen& seen) { return checkEveryLight(seen.logs); }},
        {.run = [](ShadowSeen& seen) { return checkDirectionOffset(seen.logs); }},
        // Aims outside the ball necessarily meet the objects around the light.
        {.run = failingShape, .hides = {{nullptr, &kShadowBeyondLight}}},
        // Copies of a few rays look crowded in every shape.
        {.run = crowding, .after = {{rayCounts}, {fixedSamples}}},
        {.run = [](ShadowSeen& seen) {
            return seen.aims.shapeIsRight() ? checkSeveralSizes(seen.logs, seen.aims)
                                            : std::nullopt;
        }}};
}

/// What the rays do to the colours, and further questions for code that answers these well.
std::vector<ShadowCheck> checksOfColours() {
    return std::vector<ShadowCheck>{
        {.run = [](ShadowSeen& seen) { return keepReading(seen, checkArithmetic(seen.logs)); }},
        {.run = [](ShadowSeen& seen) { return checkColourChannels(seen.logs); },
         .ifNothingFails = true},
        {.run = horizon, .ifNothingFails = true},
        {.run = contact, .ifNothingFails = true},
        {.run = backSide, .ifNothingFails = true},
        {.run = viewer},
        {.run = nearSide, .ifNothingFails = true},
        {.run = faintLight, .ifNothingFails = true},
        {.run = closeLight, .ifNothingFails = true},
        {.run = eightLights, .ifNothingFails = true},
        {.run = knownScenes<true>, .ifNothingFails = true},
        {.run = mixed<true>, .ifNothingFails = true},
        // Rays lost in pairs are lost with other settings, too, so that this check comes first.
        {.run = oddCount, .ifNothingFails = true},
        {.run = oneRay, .ifNothingFails = true},
        {.run = manyRays<true>, .ifNothingFails = true},
        {.run = otherSettings, .ifNothingFails = true},
        {.run = mixedNear, .ifNothingFails = true}};
}

const std::vector<ShadowCheck>& checksOfRays() {
    static const std::vector<ShadowCheck> kChecks = [] {
        std::vector<ShadowCheck> checks = checksOfAims();
        std::ranges::move(checksOfColours(), std::back_inserter(checks));
        return checks;
    }();
    return kChecks;
}

/// For code whose rays are not visible.
const std::vector<ShadowCheck>& checksOfValues() {
    static const std::vector<ShadowCheck> kChecks{
        {.run = [](ShadowSeen& seen) { return keepReading(seen, checkValues(seen.logs)); }},
        {.run = contact, .ifNothingFails = true},
        {.run = backSide, .ifNothingFails = true},
        {.run = faintValues, .ifNothingFails = true},
        {.run = eightValues, .ifNothingFails = true},
        {.run = knownScenes<false>, .ifNothingFails = true},
        {.run = mixed<false>, .ifNothingFails = true},
        {.run = manyRays<false>, .ifNothingFails = true},
        {.run = viewer}};
    return kChecks;
}

ShadowOutcome judgeLogged(const std::vector<ShadowLog>& all) {
    const ShadowLogs logs{all};
    ShadowOutcome outcome;
    if (std::optional<Finding> finding = checkFinite(logs)) {
        outcome.findings.push_back(*std::move(finding));
        return outcome;
    }
    const bool castsNone = castsNoRay(logs);
    outcome.onlyExtra = !castsNone && castsOnlyExtraRays(logs);
    outcome.rayless = outcome.onlyExtra || castsNone;
    outcome.cut = std::ranges::any_of(all, &ShadowLog::cut);
    ShadowSeen seen{.logs = logs};
    if (!outcome.rayless) seen.aims = judgeAims(logs.farLight);
    outcome.findings =
        runChecks<ShadowSeen>(outcome.rayless ? checksOfValues() : checksOfRays(), seen);
    outcome.reading = seen.reading;
    outcome.plots = unshown({plotAims(logs.farLight, logs.oneLight)}, outcome.findings);
    return outcome;
}

}  // namespace

ShadowOutcome judgeSoftShadows(const std::vector<ShadowLog>& all) {
    ShadowOutcome outcome = judgeLogged(all);
    if (!hasFailure(outcome.findings) || outcome.cut) return outcome;
    const std::optional<std::vector<ShadowLog>> whole = withCachedRays(all);
    if (!whole) return outcome;
    ShadowOutcome cached = judgeLogged(*whole);
    // Colours that count the missing rays as blocked are what shows the cache.
    if (!cached.reading) return outcome;
    cached.cached = true;
    return cached;
}

}  // namespace ticker::tasks
