#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/checks/PictureMistakes.h>
#include <grader/tasks/lens/checks/PictureTrial.h>
#include <grader/tasks/support/FindingOrder.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ticker::tasks {
namespace {

// The limit for the largest of about 30 z-scores: normal scores exceed 6 with a chance below 1e-7.
// Excess variances are sums of squares, which have heavier tails; beyond the last limit the picture
// changes as a whole. docs/calibration.md has the measured values.
constexpr double kMostZ = 6.0;
constexpr double kMostExcess = 9.0;
constexpr double kSharedExcess = 120.0;

Finding findingOf(const FindingText& text, const std::string& seen, const PictureMistake* runnerUp,
                  double z) {
    Finding finding = distributedFinding(
        text, Severity::fail,
        "The picture was compared with what the handout's steps give, since the rays cannot be "
        "seen: " +
            seen + ".");
    finding.evidence.emplace_back("z", z);
    if (runnerUp != nullptr)
        finding.evidence.emplace_back("runnerUp", std::string{runnerUp->text->id});
    return finding;
}

// Whether the best mistake may be named. A large difference must have its shape. A small one need
// not, since it has mostly the shape of noise.
bool hasName(const Bank& bank, double z, double meanSquares, std::size_t pixels) {
    constexpr double kShare = 0.35;
    constexpr double kSmall = 4.0;
    if (bank.best == nullptr || bank.bestMatch.z < kShare * z) return false;
    const double squares = meanSquares * static_cast<double>(pixels);
    return meanSquares < kSmall || bank.bestMatch.z * bank.bestMatch.z > kShare * squares;
}

Finding nameOf(const Bank& bank, double z, bool scaled, bool named) {
    if (scaled) return findingOf(kDofNotAveraged, "it is too bright or too dark", bank.second, z);
    if (named) return findingOf(*bank.best->text, bank.best->seen, bank.second, z);
    return findingOf(kDofWrong, "it differs in a way that is not known", bank.second, z);
}

// Whether a factor on the brightness explains nearly the whole difference, and more than any
// mistake.
bool isScaled(const SeenPictures& seen, const ExpectedPicture& expected, const Bank& bank) {
    constexpr double kNearlyAll = 0.1;
    const std::optional<Plane> scaled = rescaled(seen, expected);
    if (!scaled) return false;
    return unexplainedBy(*scaled, seen, expected) < std::min(kNearlyAll, bank.bestLeaves);
}

// Lens points that all pixels share correlate the pixels' noise. With a single picture, fifty
// shared points look by chance like a fifth of a mistake, never like half of one. Each pixel stays
// as near to its mean as with independent points: if all pixels were one, z^2 would exceed 25 with
// a chance below 1e-6.
bool mayBeSharedNoise(const SeenPictures& seen, const Bank& bank, const Excess& excess,
                      double meanSquares) {
    // The variance of eight numbers exceeds 6 times its mean with a chance below 1e-6.
    constexpr double kMostSpread = 6.0;
    constexpr double kHalf = 0.5;
    constexpr double kMostSquaredZ = 25.0;
    if (meanSquares > kMostSquaredZ) return false;
    if (seen.identical) return std::abs(bank.bestMatch.amplitude) < kHalf;
    return excess.ratio < 3.0 && bank.spread > kMostSpread * std::max(1.0, excess.ratio);
}

// With a misfit this large, rough templates suffice to name the mistake.
Exactness exactnessFor(double misfit) {
    constexpr double kClear = 25.0;
    return misfit > kClear ? Exactness::rough : Exactness::judging;
}

// Whether the mean differs from the expected one. Tiles come first, since they need no template.
bool isElsewhere(Expectations& expectations, const SeenPictures& seen,
                 const oracle::Reading& reading, const ExpectedPicture& expected,
                 Exactness ofTemplates) {
    if (largestTileZ(seen, expected) > kMostZ) return true;
    const std::size_t mistakes = pictureMistakes(reading).size();
    for (std::size_t i = 0; i < mistakes; ++i) {
        const Plane& mistaken = expectations.underMistake(reading, i, ofTemplates);
        if (beyondNegligible(matchOf(seen, expected, mistaken)) > kMostZ) return true;
    }
    return false;
}

}  // namespace

Candidate candidateOf(Expectations& expectations, const SeenPictures& seen,
                      const oracle::Reading& reading) {
    Candidate made{reading, &expectations.under(reading)};
    made.misfit = meanSquaredZ(seen, *made.expected);
    return made;
}

double roughMisfit(Expectations& expectations, const SeenPictures& seen,
                   const oracle::Reading& reading) {
    return meanSquaredZ(seen, expectations.under(reading, Exactness::rough));
}

bool isRuledOut(Expectations& expectations, const SeenPictures& seen,
                const oracle::Reading& reading) {
    const ExpectedPicture& expected = expectations.under(reading, Exactness::rough);
    return isUnlikely(meanSquaredZ(seen, expected)) ||
           isElsewhere(expectations, seen, reading, expected, Exactness::rough);
}

Trial tryReading(Expectations& expectations, const SeenPictures& seen, const Candidate& candidate) {
    const oracle::Reading& reading = candidate.reading;
    const ExpectedPicture& expected = *candidate.expected;
    const double misfit = candidate.misfit;
    const std::vector<PictureMistake> mistakes = pictureMistakes(reading);
    const Templates templates = [&](std::size_t index) -> const Plane& {
        return expectations.underMistake(reading, index, exactnessFor(misfit));
    };
    const Bank bank = tryAll(mistakes, templates, seen, expected);
    const double tile = largestTileZ(seen, expected);
    const Excess excess = excessVariance(seen, expected);
    const bool scaled = isScaled(seen, expected, bank);
    Trial trial;
    trial.total = bank.squares + tile * tile;
    PictureVerdict& verdict = trial.verdict;
    verdict.reading = reading;
    verdict.identical = seen.identical;
    verdict.largestZ = std::max(bank.largest, tile);
    verdict.excessVariance = excess.z;
    verdict.timesTheLimit = std::max(verdict.largestZ / kMostZ, excess.z / kMostExcess);
    if (excess.z > kSharedExcess && !scaled)
        verdict.finding =
            findingOf(kDofSharedSamples, "it changes as a whole from one time to the next",
                      bank.best, excess.z);
    else if (std::max(bank.beyond, tile) > kMostZ)
        verdict.finding = nameOf(bank, verdict.largestZ, scaled,
                                 hasName(bank, verdict.largestZ, misfit, seen.mean.size()));
    else if (excess.z > kMostExcess)
        verdict.finding =
            findingOf(kDofTooFewRays, "it is noisier than that many rays for each pixel can be",
                      bank.best, excess.z);
    if (verdict.finding && mayBeSharedNoise(seen, bank, excess, misfit)) {
        verdict.finding.reset();
        verdict.ambiguous = true;
    }
    if (verdict.finding) verdict.finding->rasters.push_back(zMap(seen, expected));
    return trial;
}

std::optional<Trial> tryToFit(Expectations& expectations, const SeenPictures& seen,
                              const Candidate& candidate) {
    const ExpectedPicture& expected = *candidate.expected;
    if (excessVariance(seen, expected).z > kMostExcess ||
        isElsewhere(expectations, seen, candidate.reading, expected,
                    exactnessFor(candidate.misfit)))
        return std::nullopt;
    return tryReading(expectations, seen, candidate);
}

}  // namespace ticker::tasks
