#include <grader/tasks/shadows/JudgeShadows.h>
#include <grader/tasks/shadows/JudgeSoftShadows.h>
#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/ShadowStages.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/shadows/checks/ShadowRayCounts.h>
#include <grader/tasks/support/FindingOrder.h>
#include <grader/tasks/support/RunEnd.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace ticker::tasks {
namespace {

// Takes a warning about an accepted reading out of a stage: it is no failure that has to repeat.
std::optional<Finding> takeWarning(Stage& stage) {
    if (!stage.failure || stage.failure->severity == Severity::fail) return std::nullopt;
    return std::exchange(stage.failure, std::nullopt);
}

// The rays that a render is expected to show. If `illuminate` shows only a ray to each light's
// centre, since it intersects the scene by itself, so does a render.
VisibleRays visibleRays(const ShadowOutcome& outcome, const std::vector<ShadowLog>& logs) {
    VisibleRays visible{.all = !outcome.rayless, .cached = outcome.cached};
    if (outcome.onlyExtra)
        visible.toALight = countRays(ShadowLogs{logs}.atHandoutSettings()).fewest;
    return visible;
}

// Judges by values and renders what the rays leave open.
// @return  Whether the submission needs review.
bool judgeUnseenShadows(probe::Examinee& examinee, PenumbraShelf& shelf, std::uint64_t seed,
                        ShadowOutcome& outcome) {
    // A light of the wrong size also changes points that should be fully lit.
    const bool unexplained =
        !outcome.findings.empty() && is(outcome.findings.front(), kShadowWrong);
    const bool cut = outcome.cut && !hasFailure(outcome.findings);
    const bool cached = outcome.cached && !hasFailure(outcome.findings);
    const bool rayless = outcome.rayless && (outcome.reading || unexplained);
    if (!cut && !cached && !rayless) return false;
    const char* reason = "illuminate casts no ray through findClosestIntersection";
    if (outcome.onlyExtra)
        reason =
            "illuminate casts rays to the light's centre alone through findClosestIntersection, "
            "and gives fractions of the light all the same";
    if (cached)
        reason =
            "illuminate tests the object that blocked an earlier ray without "
            "findClosestIntersection (a shadow cache), so that some blocked rays were not seen";
    if (cut) reason = "illuminate casts far more rays than asked for, so not all were followed";
    outcome.findings.push_back(unseenRays(kShadowUnseenRays, reason));
    std::optional<Finding> warning;
    const bool needsReview = keepRepeated(outcome.findings, [&](std::uint64_t stage) {
        Stage judged = judgePenumbra(examinee, shelf, seed, stage);
        warning = takeWarning(judged);
        return judged;
    });
    // If full shadow is lit, its edge has no fractions either; the edge is then not the fault.
    if (unexplained && is(outcome.findings.back(), kShadowHard)) outcome.findings.pop_back();
    if (warning && !hasFailure(outcome.findings)) outcome.findings.push_back(*std::move(warning));
    return needsReview;
}

TaskJudgement judge(probe::Examinee& examinee, std::uint64_t seed, PenumbraShelf& shelf) {
    const std::vector<ShadowQuestion> asked = drawShadowQuestions(seed);
    std::vector<probe::Question> questions;
    for (const ShadowQuestion& question : asked)
        questions.emplace_back(question.question);
    const probe::Run run = examinee.ask(questions);
    if (std::optional<TaskJudgement> blocked = judgeUnanswered(run, "illuminate"))
        return *std::move(blocked);

    std::vector<ShadowLog> logs;
    for (std::size_t i = 0; i < asked.size(); ++i)
        logs.push_back(readShadowLog(asked[i], std::get<probe::IlluminateAnswer>(run.answers[i])));
    ShadowOutcome outcome = judgeSoftShadows(logs);
    bool needsReview = judgeUnseenShadows(examinee, shelf, seed, outcome);
    if (outcome.reading && !outcome.cut && !hasFailure(outcome.findings)) {
        const VisibleRays visible = visibleRays(outcome, logs);
        const bool inRenders = keepRepeated(outcome.findings, [&](std::uint64_t stage) {
            return judgeLitRender(examinee, seed, stage, visible);
        });
        needsReview = needsReview || inRenders;
    }
    // Samples that all points share need review: they make steps at the edges of shadows.
    needsReview = needsReview || std::ranges::any_of(outcome.findings, [](const Finding& finding) {
                      return is(finding, kShadowFixedSamples);
                  });
    TaskJudgement judgement =
        judgementOf(std::move(outcome.findings), kShadowFindings, needsReview);
    judgement.plots = std::move(outcome.plots);
    return judgement;
}

}  // namespace

TaskJudgement judgeShadows(probe::Examinee& examinee, std::uint64_t seed) {
    PenumbraShelf shelf;
    return judge(examinee, seed, shelf);
}

Judge judgeShadowsOfMany() {
    return
        [shelf = std::make_shared<PenumbraShelf>()](probe::Examinee& examinee, std::uint64_t seed) {
            return judge(examinee, seed, *shelf);
        };
}

}  // namespace ticker::tasks
