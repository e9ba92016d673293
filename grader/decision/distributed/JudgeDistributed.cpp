#include <grader/decision/distributed/FindingText.h>
#include <grader/decision/distributed/JudgeDepthOfField.h>
#include <grader/decision/distributed/JudgeDistributed.h>
#include <grader/decision/distributed/JudgeSoftShadows.h>
#include <grader/decision/distributed/LensQuestions.h>
#include <grader/decision/distributed/RunEnd.h>

#include <algorithm>
#include <utility>

namespace ticker::decision {
namespace {

TaskJudgement judgementOf(std::vector<Finding> findings) {
    TaskJudgement judgement;
    judgement.findings = mostImportantFirst(std::move(findings));
    const bool failed =
        std::any_of(judgement.findings.begin(), judgement.findings.end(),
                    [](const Finding& finding) { return finding.severity == Severity::fail; });
    judgement.state = failed ? TaskState::failed : TaskState::passed;
    return judgement;
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
    TaskJudgement judgement = judgementOf(std::move(outcome.findings));
    judgement.needsReview = outcome.rayless && judgement.state == TaskState::passed;
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
    TaskJudgement judgement = judgementOf(std::move(outcome.findings));
    judgement.needsReview =
        (outcome.rayless || outcome.valueless) && judgement.state == TaskState::passed;
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
