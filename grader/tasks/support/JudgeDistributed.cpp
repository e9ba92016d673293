#include <grader/tasks/lens/FocusMistakes.h>
#include <grader/tasks/lens/JudgeDepthOfField.h>
#include <grader/tasks/lens/LensChecks.h>
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/LensQuestions.h>
#include <grader/tasks/shadows/JudgeSoftShadows.h>
#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/support/FindingText.h>
#include <grader/tasks/support/JudgeDistributed.h>
#include <grader/tasks/support/RunEnd.h>
#include <grader/tasks/support/Stages.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace ticker::tasks {
namespace {

TaskJudgement judgementOf(std::vector<Finding> findings, std::span<const FindingText* const> order,
                          bool needsReview = false) {
    TaskJudgement judgement;
    judgement.findings = mostImportantFirst(std::move(findings), order);
    const bool failed = hasFailure(judgement.findings);
    judgement.state = failed ? TaskState::failed : TaskState::passed;
    judgement.needsReview = needsReview && !failed;
    return judgement;
}

bool contains(const std::vector<Finding>& findings, const FindingText& text) {
    return std::ranges::any_of(findings, [&](const Finding& finding) { return is(finding, text); });
}

Finding unseenRays(const FindingText& text, const std::string& what) {
    Finding finding = distributedFinding(
        text, Severity::note, what + ": what it computes is judged by its results alone.");
    return finding;
}

// Judges by results what the rays do not tell. @return  Whether a person has to look.
bool judgeUnseenShadows(probe::Examinee& examinee, std::uint64_t seed, ShadowOutcome& outcome) {
    // A light of the wrong size also changes points that should be fully lit.
    const bool unexplained =
        !outcome.findings.empty() && is(outcome.findings.front(), kShadowWrong);
    const bool cut = outcome.cut && !hasFailure(outcome.findings);
    if (!cut && !(outcome.rayless && (outcome.reading || unexplained))) return false;
    outcome.findings.push_back(
        unseenRays(kShadowUnseenRays,
                   cut ? "illuminate casts far more rays than asked for, so not all were followed"
                       : "illuminate casts no ray through findClosestIntersection"));
    const bool needsReview = keepRepeated(outcome.findings, [&](std::uint64_t stage) {
        return judgePenumbra(examinee, seed, stage);
    });
    // Where full shadow is lit, its edge has no fraction either; that is not what went wrong.
    if (unexplained && is(outcome.findings.back(), kShadowHard)) outcome.findings.pop_back();
    return needsReview;
}

TaskJudgement judgeShadowTask(probe::Examinee& examinee, std::uint64_t seed) {
    const std::vector<ShadowQuestion> asked = drawShadowQuestions(seed);
    std::vector<probe::Question> questions;
    for (const ShadowQuestion& question : asked)
        questions.emplace_back(question.question);
    const probe::Sitting sitting = examinee.ask(questions);
    if (std::optional<TaskJudgement> blocked = judgeUnanswered(sitting, "illuminate"))
        return *std::move(blocked);

    std::vector<ShadowLog> logs;
    for (std::size_t i = 0; i < asked.size(); ++i)
        logs.push_back(
            readShadowLog(asked[i], std::get<probe::IlluminateAnswer>(sitting.answers[i])));
    ShadowOutcome outcome = judgeSoftShadows(logs);
    bool needsReview = judgeUnseenShadows(examinee, seed, outcome);
    if (outcome.reading && !outcome.cut && !hasFailure(outcome.findings))
        needsReview = keepRepeated(outcome.findings,
                                   [&](std::uint64_t stage) {
                                       return judgeLitRender(examinee, seed, stage);
                                   }) ||
                      needsReview;
    // The steps at the edges of shadows are for a person to see.
    needsReview = needsReview || contains(outcome.findings, kShadowFixedSamples);
    TaskJudgement judgement =
        judgementOf(std::move(outcome.findings), kShadowFindings, needsReview);
    judgement.plots = std::move(outcome.plots);
    return judgement;
}

// Looks at pictures where the rays do not tell all, and at threads and a second render where they
// do.
// @return  Whether a person has to look.
bool judgeResults(probe::Examinee& examinee, std::uint64_t seed, bool mayAntialias,
                  LensOutcome& outcome) {
    if (outcome.rayless || outcome.valueless || (outcome.cut && !hasFailure(outcome.findings))) {
        outcome.findings.push_back(unseenRays(
            kDofUnseenRays,
            outcome.cut ? "render casts far more rays than asked for, so not all were followed"
                        : "render does not send its rays through trace"));
        return keepRepeated(outcome.findings, [&](std::uint64_t stage) {
            Stage judged = judgePicture(examinee, seed, stage);
            outcome.apertureFactor = judged.apertureFactor;
            return judged;
        });
    }
    if (hasFailure(outcome.findings)) return false;
    const bool threads = keepRepeated(outcome.findings, [&](std::uint64_t stage) {
        return judgeThreads(examinee, mayAntialias, seed, stage);
    });
    if (hasFailure(outcome.findings)) return threads;
    return keepRepeated(outcome.findings,
                        [&](std::uint64_t stage) {
                            return judgeNext(examinee, mayAntialias, seed, stage);
                        }) ||
           threads;
}

// Whether rays that stay inside of the large pixels of a tiny frame do so in small ones, too.
bool antialiases(probe::Examinee& examinee, const LensLog& tiny, std::uint64_t seed) {
    if (!staysInPixels(tiny) || meetInPoints(tiny)) return false;
    const probe::RenderQuestion asked = drawFineQuestion(seed);
    const probe::Sitting sitting = examinee.ask({asked});
    const auto* answer =
        sitting.answers.empty() ? nullptr : std::get_if<probe::RenderAnswer>(&sitting.answers[0]);
    if (answer == nullptr || answer->state != probe::AnswerState::answered || answer->wrongSize)
        return false;
    return staysInPixels(readLensLog(asked, *answer));
}

TaskJudgement judgeLensTask(probe::Examinee& examinee, std::uint64_t seed,
                            std::optional<double>& apertureFactor) {
    const LensQuestions asked = drawLensQuestions(seed);
    const probe::Sitting sitting = examinee.ask({asked.handout, asked.other});
    if (std::optional<TaskJudgement> blocked = judgeUnanswered(sitting, "render"))
        return *std::move(blocked);

    const auto& handout = std::get<probe::RenderAnswer>(sitting.answers[0]);
    const auto& other = std::get<probe::RenderAnswer>(sitting.answers[1]);
    if (handout.wrongSize)
        return judgementOf({distributedFinding(kDofWrong, Severity::fail,
                                               "A picture of the size in settings() was expected; "
                                               "one of another size came back.")},
                           kLensFindings);
    LensLog atHandout = readLensLog(asked.handout, handout);
    LensLog atOther = readLensLog(asked.other, other);
    const bool mayAntialias = antialiases(examinee, atHandout, seed);
    atHandout.mayAntialias = atOther.mayAntialias = mayAntialias;
    LensOutcome outcome = judgeDepthOfField(atHandout, atOther);
    const bool needsReview = judgeResults(examinee, seed, mayAntialias, outcome);
    apertureFactor = outcome.apertureFactor;
    TaskJudgement judgement = judgementOf(std::move(outcome.findings), kLensFindings, needsReview);
    judgement.plots = std::move(outcome.plots);
    return judgement;
}

}  // namespace

DistributedJudgement judgeDistributed(probe::Examinee& examinee, const DistributedAttempt& attempt,
                                      std::uint64_t seed) {
    DistributedJudgement judgement;
    judgement.softShadows.state = TaskState::notAttempted;
    judgement.depthOfField.state = TaskState::notAttempted;
    if (attempt.softShadows) judgement.softShadows = judgeShadowTask(examinee, seed);
    if (attempt.depthOfField)
        judgement.depthOfField = judgeLensTask(examinee, seed, judgement.apertureFactor);
    return judgement;
}

}  // namespace ticker::tasks
