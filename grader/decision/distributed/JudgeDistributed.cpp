#include <grader/decision/distributed/FindingText.h>
#include <grader/decision/distributed/JudgeDepthOfField.h>
#include <grader/decision/distributed/JudgeDistributed.h>
#include <grader/decision/distributed/JudgeSoftShadows.h>
#include <grader/decision/distributed/LensQuestions.h>
#include <grader/decision/distributed/PenumbraCheck.h>
#include <grader/decision/distributed/PictureCheck.h>
#include <grader/decision/distributed/RunEnd.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace ticker::decision {
namespace {

TaskJudgement judgementOf(std::vector<Finding> findings, bool needsReview = false) {
    TaskJudgement judgement;
    judgement.findings = mostImportantFirst(std::move(findings));
    const bool failed =
        std::any_of(judgement.findings.begin(), judgement.findings.end(),
                    [](const Finding& finding) { return finding.severity == Severity::fail; });
    judgement.state = failed ? TaskState::failed : TaskState::passed;
    judgement.needsReview = needsReview && !failed;
    return judgement;
}

Finding unseenRays(const char* id, const std::string& what) {
    Finding finding = distributedFinding(
        id, Severity::note, what + ": what it computes is judged by its results alone.");
    return finding;
}

/// What a statistical stage says; answers that do not come are nothing that it could hold against
/// anybody, but somebody should look.
struct Stage {
    std::optional<Finding> finding;
    bool needsReview = false;
};

template <class Answer>
const Answer* answeredBy(const probe::Sitting& sitting) {
    if (sitting.answers.empty()) return nullptr;
    const auto* answer = std::get_if<Answer>(&sitting.answers.front());
    return answer != nullptr && answer->state == probe::AnswerState::answered ? answer : nullptr;
}

bool sameEachTime(const probe::RenderAnswer& answer) {
    return std::all_of(answer.images.begin(), answer.images.end(),
                       [&](const auto& image) { return image == answer.images.front(); });
}

Stage judgePenumbra(probe::Examinee& examinee, std::uint64_t seed, std::uint64_t stage) {
    const PenumbraQuestion asked = drawPenumbraQuestion(seed * 4 + stage);
    const probe::Sitting sitting = examinee.ask({asked.question});
    const auto* answer = answeredBy<probe::IlluminateAnswer>(sitting);
    if (answer == nullptr) return {std::nullopt, true};
    PenumbraVerdict verdict = checkPenumbra(asked, *answer);
    return {std::move(verdict.finding), verdict.ambiguous};
}

// Code that gives one picture again and again leaves a single sample of its noise: a larger picture
// is asked for, to have as many pixels as all repetitions together.
Stage judgePicture(probe::Examinee& examinee, std::uint64_t seed, std::uint64_t stage) {
    const std::uint64_t own = seed * 4 + stage;
    PictureVerdict verdict;
    for (const bool onePicture : {false, true}) {
        const probe::RenderQuestion asked = drawPictureQuestion(own, onePicture);
        const probe::Sitting sitting = examinee.ask({asked});
        const auto* answer = answeredBy<probe::RenderAnswer>(sitting);
        if (answer == nullptr || answer->wrongSize || answer->images.empty())
            return {std::nullopt, true};
        if (!onePicture && sameEachTime(*answer)) continue;
        verdict = judgePictures(asked, *answer, own);
        break;
    }
    return {std::move(verdict.finding), verdict.ambiguous};
}

// A failure that does not come again is no failure, but somebody should look.
template <class Judge>
bool keepRepeated(std::vector<Finding>& findings, const Judge& judge) {
    const Stage first = judge(1);
    if (!first.finding) return first.needsReview;
    Stage second = judge(2);
    if (!second.finding) return true;
    findings.push_back(std::move(*second.finding));
    return false;
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
    bool needsReview = false;
    // A light of the wrong size also changes points that should be fully lit.
    const bool unexplained =
        !outcome.findings.empty() && outcome.findings.front().id == "shadow.wrong";
    if (outcome.rayless && (outcome.reading || unexplained)) {
        outcome.findings.push_back(unseenRays(
            "shadow.unseen-rays", "illuminate casts no ray through findClosestIntersection"));
        needsReview = keepRepeated(outcome.findings, [&](std::uint64_t stage) {
            return judgePenumbra(examinee, seed, stage);
        });
        // Where full shadow is lit, its edge has no fraction either; that is not what went wrong.
        if (unexplained && outcome.findings.back().id == "shadow.hard") outcome.findings.pop_back();
    }
    TaskJudgement judgement = judgementOf(std::move(outcome.findings), needsReview);
    judgement.plots = std::move(outcome.plots);
    return judgement;
}

TaskJudgement judgeLensTask(probe::Examinee& examinee, std::uint64_t seed) {
    const LensQuestions asked = drawLensQuestions(seed);
    const probe::Sitting sitting = examinee.ask({asked.handout, asked.other});
    if (std::optional<TaskJudgement> blocked = judgeUnanswered(sitting, "render"))
        return *std::move(blocked);

    const auto& handout = std::get<probe::RenderAnswer>(sitting.answers[0]);
    const auto& other = std::get<probe::RenderAnswer>(sitting.answers[1]);
    if (handout.wrongSize)
        return judgementOf({distributedFinding(
            "dof.wrong", Severity::fail,
            "A picture of the size in settings() was expected; one of another size came back.")});
    LensOutcome outcome =
        judgeDepthOfField(readLensLog(asked.handout, handout), readLensLog(asked.other, other));
    bool needsReview = false;
    if (outcome.rayless || outcome.valueless) {
        outcome.findings.push_back(
            unseenRays("dof.unseen-rays", "render does not send its rays through trace"));
        needsReview = keepRepeated(outcome.findings, [&](std::uint64_t stage) {
            return judgePicture(examinee, seed, stage);
        });
    }
    TaskJudgement judgement = judgementOf(std::move(outcome.findings), needsReview);
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
    if (attempt.depthOfField) judgement.depthOfField = judgeLensTask(examinee, seed);
    return judgement;
}

}  // namespace ticker::decision
