#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/ShadowStages.h>
#include <grader/tasks/shadows/penumbra/PenumbraCheck.h>
#include <grader/tasks/support/FindingOrder.h>

#include <cstddef>
#include <optional>
#include <utility>

namespace ticker::tasks {

namespace {

// Judges a render with two threads. Threads that share a counter or a sum give wrong colours only
// where one of them lights a point while the other is in the middle of its own. On a busy machine a
// thread may wait for a processor until the other one has lit all its points; the question is then
// put again.
// @param first  The run whose second answer is the first render with two threads.
Stage judgeTogether(probe::Examinee& examinee, const probe::RenderQuestion& asked,
                    const probe::Run& first, const VisibleRays& visible) {
    // One interrupted point may have the right colour by chance.
    constexpr std::size_t kEnough = 8;
    constexpr int kMostAsks = 8;
    std::size_t interrupted = 0;
    std::optional<probe::Run> again;
    for (int asks = 1;; ++asks) {
        const probe::Run& run = again ? *again : first;
        const auto* answer = answeredBy<probe::RenderAnswer>(run, again ? 0 : 1);
        if (answer == nullptr) return unanswered(run, "render, with two threads,");
        const LitRender lit = readLitRender(asked, *answer);
        if (const auto said = litDifference(lit, visible))
            return {distributedFinding(kShadowThreadsMixed, Severity::fail,
                                       "With one thread the shadows are right; with two, and "
                                       "forEachPixel has as many as the machine has cores, " +
                                           *said + '.'),
                    std::nullopt};
        interrupted += lit.interrupted;
        if (!lit.severalThreads || interrupted >= kEnough || asks == kMostAsks) return {};
        again = examinee.ask({asked});
    }
}

}  // namespace

Stage judgePenumbra(probe::Examinee& examinee, PenumbraShelf& shelf, std::uint64_t seed,
                    std::uint64_t stage) {
    const std::uint64_t own = seedOf(seed, stage);
    const auto expectations = shelf.of(own, own);
    const probe::Run run = examinee.ask({expectations->asked().question});
    const auto* answer = answeredBy<probe::IlluminateAnswer>(run);
    if (answer == nullptr) return unanswered(run, "illuminate");
    PenumbraVerdict verdict = checkPenumbra(*expectations, *answer);
    if (verdict.ambiguous)
        return doubtful(kShadowUnseenRays,
                        "What it gives at the edges of shadows is neither clearly right nor "
                        "clearly wrong: a person has to look.");
    return {std::move(verdict.finding), std::nullopt};
}

Stage judgeLitRender(probe::Examinee& examinee, std::uint64_t seed, std::uint64_t stage,
                     const VisibleRays& visible) {
    const std::uint64_t own = seedOf(seed, stage);
    const probe::RenderQuestion asked = drawLitQuestion(own, 1);
    const probe::Run run = examinee.ask({asked, drawLitQuestion(own, 2)});
    // Faults of render itself do not count against shadows.
    const auto* alone = answeredBy<probe::RenderAnswer>(run);
    if (alone == nullptr) return {};
    if (const auto said = litDifference(readLitRender(asked, *alone), visible))
        return doubtful(kShadowNotInRenders,
                        "Asked about single points, illuminate casts the shadow rays that were "
                        "expected; inside of render, " +
                            *said + ": a person has to compare the two.");
    return judgeTogether(examinee, drawLitQuestion(own, 2), run, visible);
}

}  // namespace ticker::tasks
