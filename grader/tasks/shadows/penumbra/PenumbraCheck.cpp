#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/shadows/penumbra/PenumbraCheck.h>
#include <grader/tasks/shadows/penumbra/PenumbraFit.h>
#include <grader/tasks/shadows/penumbra/PenumbraHits.h>
#include <grader/tasks/shadows/penumbra/PenumbraShares.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ticker::tasks {
namespace {

using Place = PenumbraQuestion::Place;

// Size of the ball that explains the means, in units of lightSize; 0 if none does.
double fittingSize(PenumbraExpectations& expectations, const std::vector<PenumbraSamples>& seen) {
    // The sizes tried are a grid; between two of them the fit is approximate.
    double best = 2.0;
    double bestSize = 0.0;
    for (const double size : {0.25, 0.5, 0.6, 0.75, 0.9, 1.1, 1.25, 1.5, 1.75, 2.0, 2.5}) {
        std::vector<double> open;
        for (const PenumbraSamples& samples : seen)
            open.push_back(expectations.at(samples.place, AimShape::ball, size).open);
        const double worst = worstExcess(seen, open, open);
        if (worst >= best) continue;
        best = worst;
        bestSize = size;
    }
    return bestSize;
}

// The smallest number of rays below `asked` for which all shares are fractions; 0 if there is no
// such number.
// @param open      Share of the light in sight; some points must have fractions.
// @param fromLens  Uses points seen from the lens: some code treats camera rays differently.
int fewRays(const std::vector<PenumbraSamples>& seen, const std::vector<double>& open, int asked,
            bool fromLens) {
    for (int rays = 1; rays < asked; ++rays) {
        bool all = true;
        bool any = false;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            if (seen[i].place.fromLens != fromLens) continue;
            any = any || (open[i] > 0.1 && open[i] < 0.9);
            for (const double share : seen[i].shares) {
                const double hits = share * rays;
                all = all && std::abs(hits - std::round(hits)) < 0.01;
            }
        }
        if (all && any) return rays;
    }
    return 0;
}

std::optional<Finding> checkFractions(const std::vector<PenumbraSamples>& seen,
                                      const std::vector<double>& open, int asked) {
    const int through = fewRays(seen, open, asked, true);
    const int otherwise = fewRays(seen, open, asked, false);
    const int rays =
        through > 0 && otherwise > 0 ? std::min(through, otherwise) : std::max(through, otherwise);
    if (rays == 0) return std::nullopt;
    double spread = 0.0;
    double away = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        spread = std::max(spread, seen[i].variance);
        away = std::max(away, std::abs(seen[i].mean - open[i]));
    }
    if (rays > 1)
        return distributedFinding(
            kShadowTooFewRays, Severity::fail,
            fmt::format("{} shadow rays were expected; the light at the edge of a shadow comes in "
                        "steps of 1/{}.",
                        asked, rays));
    if (spread > 1e-9 && away > 0.15)
        return distributedFinding(kShadowAllOrNothing, Severity::fail,
                                  "At the edge of a shadow a fraction of the light was expected; "
                                  "there is all of it or none, never a part.");
    return distributedFinding(kShadowHard, Severity::fail,
                              "At the edge of a shadow a fraction of the light was expected; there "
                              "is all of it or none, as from one shadow ray.");
}

// Calls that differ only in their random numbers return one value: the samples are the same every
// time, and their mean says nothing.
bool sameEveryCall(const std::vector<PenumbraSamples>& seen) {
    std::size_t fractions = 0;
    std::size_t still = 0;
    for (const PenumbraSamples& samples : seen) {
        if (samples.mean < 0.05 || samples.mean > 0.95) continue;
        ++fractions;
        if (samples.variance < 1e-6) ++still;
    }
    return fractions >= 4 && 4 * still >= 3 * fractions;
}

constexpr double kSeen = 0.02;  // shares below may be rounding

bool seesLight(const PenumbraSamples& samples) {
    return *std::max_element(samples.shares.begin(), samples.shares.end()) > kSeen;
}

// Whether light arrives at a place that sees no part of the light. Exact: no ray of right code
// arrives there.
bool seesTooMuch(const std::vector<PenumbraSamples>& rim) {
    return std::any_of(rim.begin(), rim.end(), [](const PenumbraSamples& samples) {
        return samples.place.kind == Place::Kind::beyondRim && seesLight(samples);
    });
}

// Light that arrives in every call at places that see no part of the light: a constant that the
// code adds, or a lower limit. Light from the rim of a larger light arrives in few calls only.
double leftInShadow(const std::vector<PenumbraSamples>& rim) {
    double left = 1.0;
    for (const PenumbraSamples& samples : rim)
        if (samples.place.kind == Place::Kind::beyondRim)
            for (const double share : samples.shares)
                left = std::min(left, share);
    return left;
}

Finding leftInShadowFinding(double left) {
    Finding finding = distributedFinding(
        kShadowWrong, Severity::fail,
        fmt::format("In full shadow the ambient light alone was expected; {:.2g} of the light's "
                    "own is left there, too.",
                    left));
    finding.evidence.emplace_back("leftInShadow", left);
    return finding;
}

// Whether no light arrives at places of this kind. Within the rim some of 30000 rays arrive for
// every accepted shape, since each does with a chance above 0.002.
bool isDark(const std::vector<PenumbraSamples>& rim, Place::Kind kind) {
    return std::none_of(rim.begin(), rim.end(), [&](const PenumbraSamples& samples) {
        return samples.place.kind == kind && seesLight(samples);
    });
}

Finding explain(PenumbraExpectations& expectations, const std::vector<PenumbraSamples>& seen,
                double timesTheBound) {
    if (countsEveryHit(expectations, seen)) return everyHitCounts();
    const double size = fittingSize(expectations, seen);
    const double lightSize = expectations.asked().question.settings.lightSize;
    const double radius = size * lightSize;
    Finding finding =
        size > 0.0
            ? distributedFinding(
                  kShadowLightSize, Severity::fail,
                  fmt::format("At the edge of a shadow the mean of many calls is known for a light "
                              "of radius {}; illuminate gives about that of one of radius {:.2g}.",
                              lightSize, radius))
            : distributedFinding(
                  kShadowWrong, Severity::fail,
                  "At the edge of a shadow the mean of many calls is known; illuminate gives "
                  "another one, so that the light has the wrong size or shape, or the share is "
                  "computed wrongly.");
    if (size > 0.0) finding.evidence.emplace_back("radius", radius);
    finding.evidence.emplace_back("timesTheBound", timesTheBound);
    return finding;
}

}  // namespace

PenumbraVerdict checkPenumbra(PenumbraExpectations& expectations,
                              const probe::IlluminateAnswer& answer) {
    const PenumbraQuestion& asked = expectations.asked();
    std::vector<PenumbraSamples> seen;
    std::vector<PenumbraSamples> rim;
    for (const Place& place : asked.places)
        (place.kind == Place::Kind::penumbra ? seen : rim)
            .push_back(readSamples(asked, answer, place));

    const auto isFinite = [](const PenumbraSamples& samples) {
        return std::isfinite(samples.mean);
    };
    if (!std::all_of(seen.begin(), seen.end(), isFinite) ||
        !std::all_of(rim.begin(), rim.end(), isFinite))
        return {distributedFinding(kShadowWrong, Severity::fail,
                                   "A colour was expected from illuminate; at the edge of a shadow "
                                   "it gave NaN or infinity."),
                0.0, false};
    const bool darkRim = isDark(rim, Place::Kind::atRim);
    const bool brightBeyond = seesTooMuch(rim);
    const PenumbraFit fit = fitAcceptedShapes(expectations, seen, darkRim || brightBeyond);
    PenumbraVerdict verdict;
    verdict.timesTheBound = fit.excess();
    verdict.finding = checkFractions(seen, fit.openInBall, asked.question.settings.shadowRayCount);
    if (verdict.finding) return verdict;
    verdict.ambiguous = sameEveryCall(seen);
    if (verdict.ambiguous) return verdict;
    if (const double left = leftInShadow(rim); left > kSeen && brightBeyond)
        verdict.finding = leftInShadowFinding(left);
    else if (verdict.timesTheBound > 1.0 || brightBeyond || isDark(rim, Place::Kind::withinRim))
        verdict.finding = explain(expectations, seen, verdict.timesTheBound);
    // Of 90000 rays to the very rim at least 27 are expected for every accepted shape. Without any,
    // the light is smaller, or a table of a few hundred aims has no sample there.
    else if (darkRim)
        verdict.ambiguous = true;
    else if (fit.isNearSideAlone())
        verdict.finding = nearSideFalloff();
    return verdict;
}

}  // namespace ticker::tasks
