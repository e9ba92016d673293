#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/checks/PictureCheck.h>
#include <grader/tasks/lens/checks/PictureTrial.h>
#include <grader/tasks/lens/questions/PictureQuestions.h>
#include <grader/tasks/support/FindingOrder.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ticker::tasks {
namespace {

using oracle::Reading;

// The search for a reading that fits, and for the least bad one otherwise.
class Search {
public:
    Search(Expectations& expectations, const SeenPictures& seen)
        : expectations_(expectations), seen_(seen) {}

    PictureVerdict verdict() {
        if (!fitsHandout() && isNearerAntialiased()) tryInsideOfPixels();
        if (!fitting_) tryUnlikely();
        if (!fitting_) tryGridsToTheEdges();
        if (fitting_) return fitting_->verdict;
        chooseLeastBad();
        PictureVerdict verdict = leastBad_->verdict;
        if (verdict.finding && mayBeAntialiasedOnce()) {
            verdict.finding.reset();
            verdict.ambiguous = true;
        }
        return verdict;
    }

private:
    static constexpr double kWhole = 1.0;
    static constexpr double kHalf = 0.5;
    static constexpr double kMiddle = 0.7;  // of the pixel

    static Reading readingOf(double aperture, double spread) {
        Reading reading;
        reading.apertureFactor = aperture;
        reading.pixelSpread = spread;
        return reading;
    }
    [[nodiscard]] Candidate candidate(double aperture, double spread) const {
        return candidateOf(expectations_, seen_, readingOf(aperture, spread));
    }
    [[nodiscard]] double rough(double aperture, double spread) const {
        return roughMisfit(expectations_, seen_, readingOf(aperture, spread));
    }

    // The trial of an unlikely reading is only needed if no other one fits.
    bool fits(const Candidate& candidate) {
        tried_.push_back(candidate);
        if (!isUnlikely(candidate.misfit)) fitting_ = tryToFit(expectations_, seen_, candidate);
        return fitting_.has_value();
    }

    void tryUnlikely() {
        for (const Candidate& candidate : tried_) {
            if (!isUnlikely(candidate.misfit)) continue;
            fitting_ = tryToFit(expectations_, seen_, candidate);
            if (fitting_) return;
        }
    }

    // A grid of lens points from edge to edge blurs more than points all over the lens: a row of n
    // points at equal distances has (n + 1) / (n - 1) times the variance. Such a grid is the same
    // in every repetition.
    void tryGridsToTheEdges() {
        const double root = std::sqrt(expectations_.asked().settings.dofRayCount);
        for (const double side : {std::ceil(root), std::floor(root)})
            for (const double aperture : {kWhole, kHalf})
                for (const double spread : {0.0, 1.0}) {
                    const double wider = aperture * std::sqrt((side + 1.0) / (side - 1.0));
                    if (isRuledOut(expectations_, seen_, readingOf(wider, spread))) continue;
                    const Candidate grid = candidate(wider, spread);
                    if (isUnlikely(grid.misfit) || !hasFixedPoints(grid)) continue;
                    fitting_ = tryToFit(expectations_, seen_, grid);
                    if (fitting_) return;
                }
    }
    // Whether repetitions differ by less than with random lens points: antialiasing with fixed
    // ones has about half of their variance.
    [[nodiscard]] bool hasFixedPoints(const Candidate& one) const {
        constexpr double kLess = 0.75;
        return seen_.identical || excessVariance(seen_, *one.expected).ratio < kLess;
    }

    void chooseLeastBad() {
        for (const Candidate& candidate : tried_) {
            Trial trial = tryReading(expectations_, seen_, candidate);
            // An antialiased reading with a smaller total does not replace the least bad one so far
            // if that one's misfit may be noise of shared lens points, or if its own mistake has no
            // name.
            const PictureVerdict& verdict = trial.verdict;
            const bool isUnnamed = verdict.finding && is(*verdict.finding, kDofWrong);
            const bool isOpen = verdict.reading.pixelSpread > 0.0 && leastBad_ &&
                                (leastBad_->verdict.ambiguous || isUnnamed);
            if (!leastBad_ || (!isOpen && trial.total < leastBad_->total))
                leastBad_ = std::move(trial);
        }
    }

    bool fitsHandout() {
        const Candidate whole = candidate(kWhole, 0.0);
        misfit_ = whole.misfit;
        if (fits(whole)) return true;
        // A reading that is this much worse than another one is neither right nor the least bad.
        constexpr double kHopeless = 3.0;
        const double roughWhole = rough(kWhole, 0.0);
        const double roughHalf = rough(kHalf, 0.0);
        roughMisfit_ = std::min(roughWhole, roughHalf);
        if (roughHalf > kHopeless * roughWhole) return false;
        const Candidate half = candidate(kHalf, 0.0);
        misfit_ = std::min(misfit_, half.misfit);
        return fits(half);
    }

    // Whether antialiasing brings the misfit down far enough. Rays through the whole pixel have a
    // misfit of 0.5 to 0.8. Rays through the middle half have 5 under a spread of 1 and 2 under
    // 0.7, which is a tenth to a quarter of the misfit without antialiasing. Mistakes have 7 or
    // more, in one large picture at least half of the misfit without antialiasing.
    [[nodiscard]] bool isNear(const Candidate& antialiased) const {
        constexpr double kNearer = 0.5;
        constexpr double kFar = 6.0;
        return antialiased.misfit <= std::min(kNearer * misfit_, kFar);
    }
    // The same from a rough misfit, with wider limits: rough misfits lie closer together than real
    // ones, and true means only that the real misfit must be computed.
    [[nodiscard]] bool mayBeNear(double roughAntialiased) const {
        constexpr double kNearer = 0.9;
        constexpr double kFar = 9.0;
        return roughAntialiased <= std::min(kNearer * roughMisfit_, kFar);
    }

    // Tries rays through the whole pixel. True if they do not fit, but some antialiasing is nearer
    // than none.
    bool isNearerAntialiased() {
        bool isNearer = false;
        for (const double aperture : {kWhole, kHalf}) {
            if (mayBeNear(rough(aperture, 1.0))) {
                const Candidate whole = candidate(aperture, 1.0);
                if (isNear(whole)) {
                    nearest_ = std::min(nearest_, whole.misfit);
                    if (fits(whole)) return false;
                    isNearer = true;
                }
            }
            isNearer = isNearer || (mayBeNear(rough(aperture, kMiddle)) &&
                                    isNear(candidate(aperture, kMiddle)));
        }
        return isNearer;
    }

    // Whether antialiasing explains a single picture wholly; it then does not fail. The noise of
    // one picture is so large that antialiasing lowers its misfit by a tenth only, and the search
    // above does not find it.
    [[nodiscard]] bool mayBeAntialiasedOnce() const {
        if (!seen_.identical) return false;
        for (const double aperture : {kWhole, kHalf})
            for (const double spread : {1.0, kMiddle}) {
                if (isRuledOut(expectations_, seen_, readingOf(aperture, spread))) continue;
                const Candidate one = candidate(aperture, spread);
                if (one.misfit >= misfit_) continue;
                const std::optional<Trial> trial = tryToFit(expectations_, seen_, one);
                if (trial && trial->verdict.timesTheLimit <= 1.0) return true;
            }
        return false;
    }

    // Filters that favour the middle of a pixel (tent, bell, disc, grid) look like a smaller square
    // of the same variance. A square that is half a step of these sizes off gives z = 2 at most.
    // The least rough misfit may be a few steps from the least real one, which is then searched
    // downhill.
    void tryInsideOfPixels() {
        constexpr std::array kSizes{1.0,  0.965,   0.93, 0.895, 0.86, 0.82, 0.78,
                                    0.74, kMiddle, 0.65, 0.6,   0.55, 0.5};
        const double aperture = rough(kHalf, kMiddle) < rough(kWhole, kMiddle) ? kHalf : kWhole;
        std::size_t place = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < kSizes.size(); i += 2) {
            const double misfit = rough(aperture, kSizes.at(i));
            if (misfit >= least) continue;
            least = misfit;
            place = i;
        }
        tryDownhillFrom(place, aperture, kSizes);
    }
    void tryDownhillFrom(std::size_t place, double aperture, std::span<const double> sizes) {
        Candidate least = candidate(aperture, sizes[place]);
        const auto isBetterAt = [&](std::size_t next) {
            const Candidate one = candidate(aperture, sizes[next]);
            if (one.misfit >= least.misfit) return false;
            least = one;
            return true;
        };
        std::size_t up = place;
        while (up > 0 && isBetterAt(up - 1))
            --up;
        if (up == place)
            while (place + 1 < sizes.size() && isBetterAt(place + 1))
                ++place;
        if (least.misfit < nearest_) fits(least);
    }

    Expectations& expectations_;
    const SeenPictures& seen_;
    std::vector<Candidate> tried_;  // in the order of preference
    std::optional<Trial> fitting_;
    std::optional<Trial> leastBad_;
    double misfit_ = 0.0;                                       // least, without antialiasing
    double roughMisfit_ = 0.0;                                  // likewise, from rough pictures
    double nearest_ = std::numeric_limits<double>::infinity();  // least, with antialiasing
};

PictureVerdict notFinite() {
    PictureVerdict verdict;
    verdict.finding = distributedFinding(kDofWrong, Severity::fail,
                                         "Colours were expected; some pixels are NaN or infinite.");
    return verdict;
}

// Whether the rays miss the focal point by a share of the pixel. Code that misses it by a fixed
// length misses it by a larger share of these smaller pixels.
bool followsPixels(Expectations& expectations, const SeenPictures& seen, const Reading& reading) {
    Reading ofOwnLength = reading;
    ofOwnLength.pixelSpread *= kFinerPixels;
    // Rough misfits settle it where they are this far apart.
    constexpr double kClearly = 1.25;
    const double rough = roughMisfit(expectations, seen, reading);
    const double roughOwn = roughMisfit(expectations, seen, ofOwnLength);
    if (std::max(rough, roughOwn) > kClearly * std::min(rough, roughOwn)) return rough < roughOwn;
    return candidateOf(expectations, seen, reading).misfit <=
           candidateOf(expectations, seen, ofOwnLength).misfit;
}

}  // namespace

PictureVerdict judgePictures(Expectations& expectations, const probe::RenderAnswer& answer) {
    const SeenPictures seen = readPictures(answer);
    return seen.isFinite() ? Search{expectations, seen}.verdict() : notFinite();
}

PictureVerdict judgeFinePictures(Expectations& expectations, const probe::RenderAnswer& answer,
                                 const Reading& reading) {
    const SeenPictures seen = readPictures(answer);
    if (!seen.isFinite()) return notFinite();
    if (followsPixels(expectations, seen, reading))
        return tryReading(expectations, seen, candidateOf(expectations, seen, reading)).verdict;
    PictureVerdict verdict;
    verdict.reading = reading;
    verdict.finding = distributedFinding(
        kDofFocalPlane, Severity::fail,
        "All rays of a pixel were expected to meet in one point of the focal plane; the pictures "
        "show rays that miss it, in small pixels as far as in large ones, which is no "
        "antialiasing.");
    return verdict;
}

}  // namespace ticker::tasks
