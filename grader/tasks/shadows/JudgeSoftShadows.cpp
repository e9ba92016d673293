#include <grader/tasks/shadows/JudgeSoftShadows.h>
#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/support/FindingText.h>
#include <grader/tasks/support/Plots.h>

#include <algorithm>
#include <utility>

namespace ticker::tasks {
namespace {

void keepShadow(std::vector<Finding>& findings, std::optional<Finding> finding) {
    if (finding) findings.push_back(std::move(*finding));
}

bool castsNoRay(const ShadowLogs& logs) {
    for (const ShadowLog* log : logs.atHandoutSettings())
        for (const PointLog& point : log->points)
            if (point.lineCount() > 0) return false;
    return true;
}

void warnOfReading(const ShadowReading& reading, std::vector<Finding>& findings) {
    if (!reading.viewerIsEye) return;
    findings.push_back(distributedFinding(
        kShadowViewFromEye, Severity::warn,
        "The highlights were expected as seen from O; they come out as seen from the origin of "
        "the world."));
}

// Few of the aims are new ones.
bool repeatsItself(const AimVerdict& aims) {
    return 2 * aims.distinct < aims.lines;
}

void judgeRays(const ShadowLogs& logs, ShadowOutcome& outcome) {
    std::vector<Finding>& findings = outcome.findings;
    // Wherever these rays go, it is not the light: nothing else can be said of them.
    if (std::optional<Finding> backwards = checkBackwards(logs)) {
        findings.push_back(*std::move(backwards));
        return;
    }
    const std::optional<Finding> starts = checkStarts(logs);
    // Rays from another place than the point go elsewhere, miss the light by more and meet other
    // things than they should: all that follows from the start.
    const bool misplaced = starts && is(*starts, kShadowWrong);
    keepShadow(findings, starts);
    std::optional<Finding> fixed = checkFixedSamples(logs);
    std::optional<Finding> counts = checkRayCounts(logs, fixed.has_value());
    // Rays that start all around the point and go to the centre are no hard shadow; aims that are
    // all the centre are fixed, but that is not what went wrong.
    const bool hard = counts && is(*counts, kShadowHard);
    if (!counts && !misplaced) keepShadow(findings, checkSeveralCounts(logs, fixed.has_value()));
    const AimVerdict aims = judgeAims(logs.farLight);
    const bool copied = counts.has_value() || fixed.has_value();
    if (!copied && !misplaced) fixed = checkSmallPool(aims);
    if (counts && !(hard && starts)) keepShadow(findings, std::move(counts));
    if (!hard) keepShadow(findings, std::move(fixed));
    if (misplaced) return;
    keepShadow(findings, checkEveryLight(logs));
    keepShadow(findings, checkDirectionOffset(logs));
    // Copies of a few rays crowd wherever they go.
    std::optional<Finding> shape = checkAims(logs, aims);
    const bool astray = shape && shape->severity == Severity::fail;
    const bool copies = copied || repeatsItself(aims);
    if (shape && (astray || !copies)) keepShadow(findings, std::move(shape));
    if (aims.shapeIsRight()) keepShadow(findings, checkSeveralSizes(logs, aims));

    ArithmeticVerdict arithmetic = checkArithmetic(logs);
    // Aims that miss the ball meet what stands around the light, rightly.
    const bool follows =
        astray && arithmetic.finding && is(*arithmetic.finding, kShadowBeyondLight);
    if (!follows) keepShadow(findings, std::move(arithmetic.finding));
    outcome.reading = arithmetic.reading;
    if (outcome.reading && !hasFailure(findings))
        keepShadow(findings, checkHorizon(logs, aims, *outcome.reading));
}

}  // namespace

ShadowOutcome judgeSoftShadows(const std::vector<ShadowLog>& all) {
    const ShadowLogs logs{all};
    ShadowOutcome outcome;
    if (std::optional<Finding> finding = checkFinite(logs)) {
        outcome.findings.push_back(std::move(*finding));
        return outcome;
    }
    outcome.rayless = castsNoRay(logs);
    outcome.cut = std::ranges::any_of(all, &ShadowLog::cut);
    if (outcome.rayless) {
        ArithmeticVerdict values = checkValues(logs);
        keepShadow(outcome.findings, std::move(values.finding));
        outcome.reading = values.reading;
    } else {
        judgeRays(logs, outcome);
    }
    if (outcome.reading) warnOfReading(*outcome.reading, outcome.findings);
    if (outcome.reading && !outcome.rayless && !hasFailure(outcome.findings))
        keepShadow(outcome.findings, checkOtherSettings(logs));
    outcome.plots = unshown({plotAims(logs.farLight)}, outcome.findings);
    return outcome;
}

}  // namespace ticker::tasks
