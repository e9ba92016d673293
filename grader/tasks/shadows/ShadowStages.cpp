#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/ShadowStages.h>
#include <grader/tasks/shadows/penumbra/PenumbraCheck.h>
#include <grader/tasks/support/FindingOrder.h>

#include <array>
#include <utility>

namespace ticker::tasks {

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
    const std::array asked{drawLitQuestion(own, 1), drawLitQuestion(own, 2)};
    const probe::Run run = examinee.ask({asked[0], asked[1]});
    // Faults of render itself do not count against shadows.
    const auto* alone = answeredBy<probe::RenderAnswer>(run);
    if (alone == nullptr) return {};
    if (const auto said = litDifference(readLitRender(asked[0], *alone), visible))
        return doubtful(kShadowNotInRenders,
                        "Asked about single points, illuminate casts the shadow rays that were "
                        "expected; inside of render, " +
                            *said + ": a person has to compare the two.");
    const auto* together = answeredBy<probe::RenderAnswer>(run, 1);
    if (together == nullptr) return unanswered(run, "render, with two threads,");
    if (const auto said = litDifference(readLitRender(asked[1], *together), visible))
        return {distributedFinding(kShadowThreadsMixed, Severity::fail,
                                   "With one thread the shadows are right; with two, and "
                                   "forEachPixel has as many as the machine has cores, " +
                                       *said + '.'),
                std::nullopt};
    return {};
}

}  // namespace ticker::tasks
