#include <grader/tasks/lens/JudgeDepthOfField.h>
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/LensStages.h>
#include <grader/tasks/lens/answers/LensThreads.h>
#include <grader/tasks/lens/checks/PictureCheck.h>
#include <grader/tasks/lens/questions/LensQuestions.h>
#include <grader/tasks/lens/questions/PictureQuestions.h>
#include <grader/tasks/support/FindingOrder.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ticker::tasks {
namespace {

bool sameEachTime(const probe::RenderAnswer& answer) {
    return std::ranges::all_of(answer.images,
                               [&](const auto& image) { return image == answer.images.front(); });
}

// The accepted factor, 1 or 0.5, that a reading stands for. The reading of a grid from edge to edge
// is wider by about a seventh (see `tryGridsToTheEdges`).
double acceptedAperture(const oracle::Reading& reading) {
    constexpr double kBetween = 0.75;
    return reading.apertureFactor < kBetween ? 0.5 : 1.0;
}

PictureStage stageOf(PictureVerdict verdict) {
    if (verdict.ambiguous)
        return {doubtful(kDofUnseenRays,
                         "Its pictures are neither clearly right nor clearly wrong: a person has "
                         "to compare them.")};
    return {{std::move(verdict.finding), std::nullopt, acceptedAperture(verdict.reading)},
            verdict.reading.pixelSpread > 0.0};
}

// What looks like antialiasing must do so in smaller pixels, too.
PictureStage judgeFinePicture(probe::Examinee& examinee, ExpectationShelf& shelf,
                              const oracle::Reading& reading, std::uint64_t own) {
    const probe::RenderQuestion asked = drawFinePictureQuestion(own);
    const probe::Run run = examinee.ask({asked});
    const auto* answer = answeredBy<probe::RenderAnswer>(run);
    if (answer == nullptr || answer->wrongSize || answer->images.empty())
        return {unanswered(run, "render")};
    return stageOf(judgeFinePictures(*expectationsOf(shelf, asked, own), *answer, reading));
}

}  // namespace

std::optional<Finding> failureAlone(probe::Examinee& examinee, probe::RenderQuestion asked,
                                    bool mayAntialias) {
    asked.settings.threads = 1;
    const probe::Run run = examinee.ask({asked});
    const auto* answer = answeredBy<probe::RenderAnswer>(run);
    if (answer == nullptr || answer->wrongSize) return std::nullopt;
    LensLog log = readLensLog(asked, *answer);
    log.mayAntialias = mayAntialias;
    return judgeAnotherScene(log);
}

// Code that repeats one picture yields a single sample of its noise. It is asked for a larger
// picture, with about as many pixels as all repetitions together.
PictureStage judgePicture(probe::Examinee& examinee, ExpectationShelf& shelf, std::uint64_t seed,
                          std::uint64_t stage) {
    const std::uint64_t own = seedOf(seed, stage);
    for (const bool onePicture : {false, true}) {
        const probe::RenderQuestion asked = drawPictureQuestion(own, onePicture);
        const probe::Run run = examinee.ask({asked});
        const auto* answer = answeredBy<probe::RenderAnswer>(run);
        if (answer == nullptr || answer->wrongSize || answer->images.empty())
            return {unanswered(run, "render")};
        if (!onePicture && sameEachTime(*answer)) continue;
        PictureVerdict verdict = judgePictures(*expectationsOf(shelf, asked, own), *answer);
        if (verdict.reading.pixelSpread > 0.0 && !verdict.finding && !verdict.ambiguous)
            return judgeFinePicture(examinee, shelf, verdict.reading, own);
        return stageOf(std::move(verdict));
    }
    return {};
}

// Threads that share a sum or a lens point give wrong pixels only where one of them traces while
// the other is in the middle of a pixel. On a busy machine a thread may wait for a processor until
// the other one has drawn all pixels; the question is then put again.
Stage judgeThreads(probe::Examinee& examinee, bool mayAntialias, std::uint64_t seed,
                   std::uint64_t stage) {
    constexpr std::size_t kEnough = 8;  // one interrupted pixel may be right by chance
    constexpr int kMostAsks = 8;
    const probe::RenderQuestion asked = drawThreadsQuestion(seedOf(seed, stage));
    std::size_t interrupted = 0;
    for (int asks = 1;; ++asks) {
        const probe::Run run = examinee.ask({asked});
        const auto* answer = answeredBy<probe::RenderAnswer>(run);
        if (answer == nullptr || answer->wrongSize) return unanswered(run, "render");
        LensLog log = readLensLog(asked, *answer);
        log.mayAntialias = mayAntialias;
        if (std::optional<Finding> withThreads = judgeWithThreads(log)) {
            if (std::optional<Finding> alone = failureAlone(examinee, asked, mayAntialias))
                return {.failure = std::move(alone), .doubt = {}, .decided = true};
            return {std::move(withThreads), std::nullopt};
        }
        const ThreadsMet met = threadsMet(answer->events);
        interrupted += met.interrupted;
        if (!met.several || interrupted >= kEnough || asks == kMostAsks) return {};
    }
}

// Only the second picture is judged. The first one shows a part of a frame, and code that draws the
// whole frame instead would give nothing to compare.
Stage judgeNext(probe::Examinee& examinee, bool mayAntialias, std::uint64_t seed,
                std::uint64_t stage) {
    const NextRender asked = drawNextRender(seedOf(seed, stage));
    const probe::Run run = examinee.ask({asked.before, asked.next});
    const auto* answer = answeredBy<probe::RenderAnswer>(run, 1);
    if (answer == nullptr || answer->wrongSize) return {};
    LensLog log = readLensLog(asked.next, *answer);
    log.mayAntialias = mayAntialias;
    std::optional<Finding> asNext = judgeNextRender(log);
    if (!asNext) return {};
    if (std::optional<Finding> alone = failureAlone(examinee, asked.next, mayAntialias))
        return {.failure = std::move(alone), .doubt = {}, .decided = true};
    return {std::move(asNext), std::nullopt};
}

}  // namespace ticker::tasks
