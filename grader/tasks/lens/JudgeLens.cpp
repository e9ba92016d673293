#include <grader/result/GeneralFindings.h>
#include <grader/tasks/lens/JudgeDepthOfField.h>
#include <grader/tasks/lens/JudgeLens.h>
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/LensStages.h>
#include <grader/tasks/lens/checks/FocusMistakes.h>
#include <grader/tasks/lens/checks/LensChecks.h>
#include <grader/tasks/lens/questions/LensQuestions.h>
#include <grader/tasks/support/FindingOrder.h>
#include <grader/tasks/support/RunEnd.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace ticker::tasks {
namespace {

Finding antialiasedPicture() {
    return distributedFinding(
        kDofAntialiased, Severity::warn,
        "All rays of a pixel were expected to meet in one point of the focal plane; the pictures "
        "are those of rays that go through different places of the pixel's own square there, "
        "which is antialiasing. They are right, with smoother edges than the handout's.");
}

// Judges pictures, for code whose logged rays leave something open.
// @return  Whether the submission needs review.
bool judgeUnseen(probe::Examinee& examinee, ExpectationShelf& shelf, std::uint64_t seed,
                 LensOutcome& outcome) {
    outcome.findings.push_back(unseenRays(
        kDofUnseenRays,
        outcome.cut ? "render casts far more rays than asked for, so not all were followed"
        : outcome.partly
            ? "render sends the rays of some pixels through trace, but not those of others"
        : outcome.onlyExtra
            ? "render sends one pinhole ray of each pixel through trace, and none of the others"
            : "render does not send its rays through trace"));
    bool antialiased = false;
    const bool needsReview = keepRepeated(outcome.findings, [&](std::uint64_t stage) {
        PictureStage judged = judgePicture(examinee, shelf, seed, stage);
        outcome.apertureFactor = judged.stage.apertureFactor;
        antialiased = judged.antialiased;
        return judged.stage;
    });
    if (antialiased && !hasFailure(outcome.findings) && !isAntialiased(outcome.findings))
        outcome.findings.push_back(antialiasedPicture());
    return needsReview;
}

// Judges pictures if the rays leave something open; otherwise a render with two threads, then one
// after another render in the same program.
// @return  Whether the submission needs review.
bool judgeResults(probe::Examinee& examinee, ExpectationShelf& shelf, std::uint64_t seed,
                  bool mayAntialias, LensOutcome& outcome) {
    if (outcome.rayless || outcome.valueless || (outcome.cut && !hasFailure(outcome.findings)))
        return judgeUnseen(examinee, shelf, seed, outcome);
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

// Whether rays that stay inside the large pixels of a tiny frame also stay inside small ones.
bool antialiases(probe::Examinee& examinee, const LensLog& tiny, std::uint64_t seed) {
    if (!staysInPixels(tiny) || meetInPoints(tiny)) return false;
    const probe::RenderQuestion asked = drawFineQuestion(seed);
    const probe::Run run = examinee.ask({asked});
    const auto* answer =
        run.answers.empty() ? nullptr : std::get_if<probe::RenderAnswer>(&run.answers[0]);
    if (answer == nullptr || answer->state != probe::AnswerState::answered || answer->wrongSize)
        return false;
    return staysInPixels(readLensLog(asked, *answer));
}

// Asks about the scene of the other settings with the handout's numbers. If the answer is wrong
// again, the settings are not the cause, and its failure replaces the warning. The frame's size
// stays, so that the warning remains if the code loses rows of that frame only.
void confirmSettings(probe::Examinee& examinee, const LensQuestions& asked, bool mayAntialias,
                     std::vector<Finding>& findings) {
    const auto blamed = std::ranges::find_if(
        findings, [](const Finding& finding) { return is(finding, kSettingsHardCoded); });
    if (blamed == findings.end()) return;
    probe::RenderQuestion again = asked.other;
    again.settings = asked.handout.settings;
    again.settings.width = asked.other.settings.width;
    again.settings.height = asked.other.settings.height;
    if (std::optional<Finding> alone = failureAlone(examinee, again, mayAntialias))
        *blamed = *std::move(alone);
}

// Judges an odd number of rays, for code whose rays are visible and right at the handout's number.
// Rays lost in pairs are lost with other settings, too, so that this finding replaces the warning
// about settings. If the scene is wrong with the handout's number as well, that failure is reported
// instead.
void askOddCount(probe::Examinee& examinee, const LensQuestions& asked, const LensLog& odd,
                 std::vector<Finding>& findings) {
    if (hasFailure(findings)) return;
    std::optional<Finding> wrong = judgeOddCount(odd);
    if (!wrong) return;
    probe::RenderQuestion again = asked.odd;
    again.settings.dofRayCount = asked.handout.settings.dofRayCount;
    if (std::optional<Finding> alone = failureAlone(examinee, again, odd.mayAntialias))
        wrong = std::move(alone);
    std::erase_if(findings, [](const Finding& finding) { return is(finding, kSettingsHardCoded); });
    findings.push_back(*std::move(wrong));
}

// The failure of the log's scene at the handout's settings; empty if it is right there.
std::optional<Finding> wrongAtHandout(probe::Examinee& examinee, const LensLog& log) {
    probe::RenderQuestion again = *log.asked;
    again.settings = raytracer::RenderSettings{};
    again.settings.seed = log.asked->settings.seed;
    again.settings.width = log.asked->settings.width;
    again.settings.height = log.asked->settings.height;
    return failureAlone(examinee, again, log.mayAntialias);
}

// Judges more than 255 rays, for code whose rays are visible and follow the number that is asked
// for.
void askManyRays(probe::Examinee& examinee, const LensLog& many, const LensLog& handout,
                 const LensLog& other, std::vector<Finding>& findings) {
    if (hasFailure(findings)) return;
    std::optional<Finding> wrong = judgeManyRays(many, handout, other);
    if (!wrong) return;
    if (std::optional<Finding> alone = wrongAtHandout(examinee, many)) wrong = std::move(alone);
    std::erase_if(findings, [](const Finding& finding) { return is(finding, kSettingsHardCoded); });
    findings.push_back(*std::move(wrong));
}

// The cause of a wrong mixed render. If the render is right in a fresh program, it kept something
// from the render before. If its scene is wrong at the handout's settings, too, that failure is the
// cause. Otherwise the cause is `wrong`.
Finding renamedByCause(probe::Examinee& examinee, const LensLog& log, Finding wrong) {
    if (!failureAlone(examinee, *log.asked, log.mayAntialias))
        return judgeNextRender(log).value_or(std::move(wrong));
    return wrongAtHandout(examinee, log).value_or(std::move(wrong));
}

// Judges mixed renders, for code whose rays are visible and right with other settings.
void askMixed(probe::Examinee& examinee, const std::vector<LensLog>& logs,
              std::vector<Finding>& findings) {
    const auto keeps = [](const Finding& finding) { return is(finding, kSettingsHardCoded); };
    if (hasFailure(findings) || std::ranges::any_of(findings, keeps)) return;
    for (const LensLog& log : logs) {
        if (log.cut) continue;
        std::optional<Finding> wrong = judgeMixed(log);
        if (!wrong) continue;
        findings.push_back(lacksRays(log) ? *std::move(wrong)
                                          : renamedByCause(examinee, log, *std::move(wrong)));
        return;
    }
}

// The logs of the renders whose answers start at index `from`. Pictures of a wrong size are left
// out.
std::vector<LensLog> readLogs(const std::vector<probe::RenderQuestion>& asked,
                              const probe::Run& run, std::size_t from) {
    std::vector<LensLog> logs;
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (const auto& answer = std::get<probe::RenderAnswer>(run.answers[from + i]);
            !answer.wrongSize)
            logs.push_back(readLensLog(asked[i], answer));
    return logs;
}

TaskJudgement judge(probe::Examinee& examinee, std::uint64_t seed, ExpectationShelf& shelf) {
    const LensQuestions asked = drawLensQuestions(seed);
    std::vector<probe::Question> questions{asked.handout, asked.other, asked.odd, asked.many};
    const std::size_t single = questions.size();
    questions.insert(questions.end(), asked.mixed.begin(), asked.mixed.end());
    const probe::Run run = examinee.ask(questions);
    if (std::optional<TaskJudgement> blocked = judgeUnanswered(run, "render"))
        return *std::move(blocked);

    const auto& handout = std::get<probe::RenderAnswer>(run.answers[0]);
    const auto& other = std::get<probe::RenderAnswer>(run.answers[1]);
    if (handout.wrongSize)
        return judgementOf({distributedFinding(kDofWrong, Severity::fail,
                                               "A picture of the size in settings() was expected; "
                                               "one of another size came back.")},
                           kLensFindings);
    LensLog atHandout = readLensLog(asked.handout, handout);
    LensLog atOther = readLensLog(asked.other, other);
    LensLog atOdd = readLensLog(asked.odd, std::get<probe::RenderAnswer>(run.answers[2]));
    LensLog many = readLensLog(asked.many, std::get<probe::RenderAnswer>(run.answers[3]));
    std::vector<LensLog> mixed = readLogs(asked.mixed, run, single);
    const bool mayAntialias = antialiases(examinee, atHandout, seed);
    for (LensLog* log : {&atHandout, &atOther, &atOdd, &many})
        log->mayAntialias = mayAntialias;
    for (LensLog& log : mixed)
        log.mayAntialias = mayAntialias;
    LensOutcome outcome = judgeDepthOfField(atHandout, atOther);
    if (!outcome.rayless) {
        askOddCount(examinee, asked, atOdd, outcome.findings);
        askManyRays(examinee, many, atHandout, atOther, outcome.findings);
        if (!outcome.valueless) askMixed(examinee, mixed, outcome.findings);
    }
    if (!lacksRays(atOther)) confirmSettings(examinee, asked, mayAntialias, outcome.findings);
    const bool needsReview = judgeResults(examinee, shelf, seed, mayAntialias, outcome);
    TaskJudgement judgement = judgementOf(std::move(outcome.findings), kLensFindings, needsReview);
    judgement.apertureFactor = outcome.apertureFactor;
    judgement.plots = std::move(outcome.plots);
    return judgement;
}

}  // namespace

TaskJudgement judgeLens(probe::Examinee& examinee, std::uint64_t seed) {
    ExpectationShelf shelf;
    return judge(examinee, seed, shelf);
}

Judge judgeLensOfMany() {
    return [shelf = std::make_shared<ExpectationShelf>()](probe::Examinee& examinee,
                                                          std::uint64_t seed) {
        return judge(examinee, seed, *shelf);
    };
}

}  // namespace ticker::tasks
