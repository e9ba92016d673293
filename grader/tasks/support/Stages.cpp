#include <grader/result/GeneralFindings.h>
#include <grader/tasks/lens/JudgeDepthOfField.h>
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/LensQuestions.h>
#include <grader/tasks/lens/PictureCheck.h>
#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/checks/LitRender.h>
#include <grader/tasks/shadows/checks/PenumbraCheck.h>
#include <grader/tasks/support/FindingText.h>
#include <grader/tasks/support/RunEnd.h>
#include <grader/tasks/support/Stages.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace ticker::tasks {
namespace {

std::uint64_t seedOf(std::uint64_t seed, std::uint64_t stage) {
    return seed * 4 + stage;
}

Stage doubtful(const FindingText& text, std::string why) {
    return {std::nullopt, distributedFinding(text, Severity::warn, std::move(why))};
}

// Answers that do not come here, though they came before, are nothing to fail by.
Stage unanswered(const probe::Sitting& sitting, std::string_view function) {
    std::optional<TaskJudgement> blocked = judgeUnanswered(sitting, function);
    if (!blocked || blocked->findings.empty())
        return doubtful(kRunNoAnswer, "Questions that were asked once more got no answer.");
    Finding doubt = std::move(blocked->findings.front());
    doubt.severity = Severity::warn;
    return {std::nullopt, std::move(doubt)};
}

template <class Answer>
const Answer* answeredBy(const probe::Sitting& sitting, std::size_t question = 0) {
    if (sitting.answers.size() <= question) return nullptr;
    const auto* answer = std::get_if<Answer>(&sitting.answers[question]);
    return answer != nullptr && answer->state == probe::AnswerState::answered ? answer : nullptr;
}

bool sameEachTime(const probe::RenderAnswer& answer) {
    return std::ranges::all_of(answer.images,
                               [&](const auto& image) { return image == answer.images.front(); });
}

Stage stageOf(PictureVerdict verdict) {
    if (verdict.ambiguous)
        return doubtful(kDofUnseenRays,
                        "Its pictures are neither clearly right nor clearly wrong: a person has to "
                        "compare them.");
    return {std::move(verdict.finding), std::nullopt, verdict.apertureFactor};
}

}  // namespace

Stage judgePenumbra(probe::Examinee& examinee, std::uint64_t seed, std::uint64_t stage) {
    const PenumbraQuestion asked = drawPenumbraQuestion(seedOf(seed, stage));
    const probe::Sitting sitting = examinee.ask({asked.question});
    const auto* answer = answeredBy<probe::IlluminateAnswer>(sitting);
    if (answer == nullptr) return unanswered(sitting, "illuminate");
    PenumbraVerdict verdict = checkPenumbra(asked, *answer);
    if (verdict.ambiguous)
        return doubtful(kShadowUnseenRays,
                        "What it gives at the edges of shadows is neither clearly right nor "
                        "clearly wrong: a person has to look.");
    return {std::move(verdict.finding), std::nullopt};
}

// Code that gives one picture again and again leaves a single sample of its noise: a larger picture
// is asked for, to have as many pixels as all repetitions together.
Stage judgePicture(probe::Examinee& examinee, std::uint64_t seed, std::uint64_t stage) {
    const std::uint64_t own = seedOf(seed, stage);
    for (const bool onePicture : {false, true}) {
        const probe::RenderQuestion asked = drawPictureQuestion(own, onePicture);
        const probe::Sitting sitting = examinee.ask({asked});
        const auto* answer = answeredBy<probe::RenderAnswer>(sitting);
        if (answer == nullptr || answer->wrongSize || answer->images.empty())
            return unanswered(sitting, "render");
        if (onePicture || !sameEachTime(*answer))
            return stageOf(judgePictures(asked, *answer, own));
    }
    return {};
}

Stage judgeThreads(probe::Examinee& examinee, bool mayAntialias, std::uint64_t seed,
                   std::uint64_t stage) {
    const probe::RenderQuestion asked = drawThreadsQuestion(seedOf(seed, stage));
    const probe::Sitting sitting = examinee.ask({asked});
    const auto* answer = answeredBy<probe::RenderAnswer>(sitting);
    if (answer == nullptr || answer->wrongSize) return unanswered(sitting, "render");
    LensLog log = readLensLog(asked, *answer);
    log.mayAntialias = mayAntialias;
    return {judgeWithThreads(log), std::nullopt};
}

// What goes wrong in the picture before is no matter here: it is of a part of a frame, and code
// that draws the whole one leaves nothing to compare.
Stage judgeNext(probe::Examinee& examinee, bool mayAntialias, std::uint64_t seed,
                std::uint64_t stage) {
    const NextRender asked = drawNextRender(seedOf(seed, stage));
    const probe::Sitting sitting = examinee.ask({asked.before, asked.next});
    const auto* answer = answeredBy<probe::RenderAnswer>(sitting, 1);
    if (answer == nullptr || answer->wrongSize) return {};
    LensLog log = readLensLog(asked.next, *answer);
    log.mayAntialias = mayAntialias;
    return {judgeNextRender(log), std::nullopt};
}

Stage judgeLitRender(probe::Examinee& examinee, std::uint64_t seed, std::uint64_t stage) {
    const std::uint64_t own = seedOf(seed, stage);
    const std::array asked{drawLitQuestion(own, 1), drawLitQuestion(own, 2)};
    const probe::Sitting sitting = examinee.ask({asked[0], asked[1]});
    // What render itself does wrong is no matter of shadows.
    const auto* alone = answeredBy<probe::RenderAnswer>(sitting);
    if (alone == nullptr) return {};
    if (const auto said = litDifference(readLitRender(asked[0], *alone)))
        return doubtful(kShadowNotInRenders,
                        "Asked about single points, illuminate casts the shadow rays that were "
                        "expected; inside of render, " +
                            *said + ": a person has to compare the two.");
    const auto* together = answeredBy<probe::RenderAnswer>(sitting, 1);
    if (together == nullptr) return unanswered(sitting, "render, with two threads,");
    if (const auto said = litDifference(readLitRender(asked[1], *together)))
        return {distributedFinding(kShadowThreadsMixed, Severity::fail,
                                   "With one thread the shadows are right; with two, and "
                                   "forEachPixel has as many as the machine has cores, " +
                                       *said + '.'),
                std::nullopt};
    return {};
}

bool keepRepeated(std::vector<Finding>& findings,
                  const std::function<Stage(std::uint64_t)>& judge) {
    Stage first = judge(1);
    if (first.failure) {
        Stage second = judge(2);
        if (second.failure) {
            findings.push_back(*std::move(second.failure));
            return false;
        }
        first.failure->severity = Severity::warn;
        first.failure->message +=
            " It did not come again with other questions: a person has to look.";
        first.doubt = std::move(first.failure);
    }
    if (!first.doubt) return false;
    findings.push_back(*std::move(first.doubt));
    return true;
}

}  // namespace ticker::tasks
