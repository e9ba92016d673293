#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/checks/PictureCheck.h>
#include <grader/tasks/lens/checks/PictureTrial.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/FindingOrder.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace ticker::tasks {
namespace {

using oracle::Reading;

// Eight pictures of 24 x 18 pixels, or one picture with as many pixels.
constexpr int kPictureWidth = 24;
constexpr int kPictureRepetitions = 8;
constexpr int kLargeWidth = 68;
// For the same focal points in pixels of half the size, and still some repetitions.
constexpr int kFineWidth = 48;
constexpr int kFineRepetitions = 4;

// The search for a reading that fits, and for the least bad one otherwise.
class Search {
public:
    Search(const probe::RenderQuestion& asked, const SeenPictures& seen, std::uint64_t seed)
        : asked_(asked), seen_(seen), seed_(seed) {}

    PictureVerdict verdict() {
        if (!fitsHandout() && isNearerAntialiased()) tryInsideOfPixels();
        return best_->verdict;
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
        return candidateOf(asked_, seen_, readingOf(aperture, spread), seed_);
    }
    [[nodiscard]] double rough(double aperture, double spread) const {
        return roughMisfit(asked_, seen_, readingOf(aperture, spread), seed_);
    }

    bool fits(const Candidate& candidate) {
        Trial trial = tryReading(asked_, seen_, candidate, seed_);
        const bool isFit = trial.fits();
        // What may be the noise of shared lens points is no failure of antialiasing, and a mistake
        // that has a name without it does not lose that name.
        const bool isUnnamed = trial.verdict.finding && is(*trial.verdict.finding, kDofWrong);
        const bool isOpen =
            candidate.reading.pixelSpread > 0.0 && best_ && (best_->verdict.ambiguous || isUnnamed);
        if (isFit || !best_ || (!isOpen && trial.total < best_->total)) best_ = std::move(trial);
        return isFit;
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

    // Rays through all of their pixel have a misfit of 0.5 to 0.8, those through its middle half 5
    // with the whole and 2 with 0.7 of it, a tenth to a quarter of that without antialiasing. Of
    // mistakes it is 7 and more, in one large picture half of that without and more.
    [[nodiscard]] bool isNear(const Candidate& antialiased) const {
        constexpr double kNearer = 0.5;
        constexpr double kFar = 6.0;
        return antialiased.misfit <= std::min(kNearer * misfit_, kFar);
    }
    // False only for what is not near by far. Rough misfits lie closer together than real ones.
    [[nodiscard]] bool mayBeNear(double roughAntialiased) const {
        constexpr double kNearer = 0.9;
        constexpr double kFar = 9.0;
        return roughAntialiased <= std::min(kNearer * roughMisfit_, kFar);
    }

    // @return  Whether the best is some antialiasing, but not of the usual kind.
    bool isNearerAntialiased() {
        bool isNearer = false;
        for (const double aperture : {kWhole, kHalf}) {
            if (mayBeNear(rough(aperture, 1.0))) {
                const Candidate whole = candidate(aperture, 1.0);
                if (isNear(whole)) {
                    if (fits(whole)) return false;
                    nearest_ = std::min(nearest_, whole.misfit);
                    isNearer = true;
                }
            }
            isNearer = isNearer || (mayBeNear(rough(aperture, kMiddle)) &&
                                    isNear(candidate(aperture, kMiddle)));
        }
        return isNearer;
    }

    // Filters that favour the middle of a pixel (tent, bell, disc, grid) look like a smaller square
    // of the same variance. A quarter of a step of these sizes is z = 2 at most.
    void tryInsideOfPixels() {
        constexpr std::array kSizes{1.0, 0.93, 0.86, 0.78, kMiddle, 0.6, 0.5};
        const double aperture = rough(kHalf, kMiddle) < rough(kWhole, kMiddle) ? kHalf : kWhole;
        std::array<double, kSizes.size()> misfits{};
        std::ranges::transform(kSizes, misfits.begin(),
                               [&](double size) { return rough(aperture, size); });
        const auto place =
            static_cast<std::size_t>(std::ranges::min_element(misfits) - misfits.begin());
        const double size = kSizes.at(place);
        std::vector<double> sizes{size};
        if (place > 0) sizes.push_back(std::midpoint(kSizes.at(place - 1), size));
        if (place + 1 < kSizes.size()) sizes.push_back(std::midpoint(kSizes.at(place + 1), size));
        tryNearest(aperture, sizes);
    }
    void tryNearest(double aperture, const std::vector<double>& sizes) {
        std::optional<Candidate> nearest;
        for (const double size : sizes) {
            Candidate one = candidate(aperture, size);
            if (one.misfit >= nearest_) continue;
            nearest_ = one.misfit;
            nearest = std::move(one);
        }
        if (nearest) fits(*nearest);
    }

    const probe::RenderQuestion& asked_;
    const SeenPictures& seen_;
    std::uint64_t seed_;
    std::optional<Trial> best_;
    double misfit_ = 0.0;                                       // least, without antialiasing
    double roughMisfit_ = 0.0;                                  // likewise, from rough pictures
    double nearest_ = std::numeric_limits<double>::infinity();  // least, with antialiasing
};

}  // namespace

probe::RenderQuestion drawPictureQuestion(std::uint64_t seed, bool onePicture) {
    Draw draw{seed, 23};
    probe::RenderQuestion question;
    question.settings.width = onePicture ? kLargeWidth : kPictureWidth;
    question.settings.height = question.settings.width * 3 / 4;
    question.settings.seed = draw.word() >> 1U;
    question.repetitions = onePicture ? 1 : kPictureRepetitions;
    question.scene.ambientLighting = ColourRGB{1.0};
    for (int i = 0; i < 40; ++i) {
        raytracer::Material material;
        material.colour = draw.colour(0.05, 1.0);
        material.reflectivity = draw.between(0.1, 0.4);
        const double z = draw.between(1.8, 9.0);
        const double x = draw.between(-0.42, 0.42) * z;
        const Vector3 centre{x, draw.between(-0.32, 0.32) * z, z};
        question.scene.spheres.push_back({centre, draw.between(0.02, 0.06) * z, material, nullptr});
    }
    raytracer::Material wall;
    wall.colour = draw.colour(0.2, 0.8);
    question.scene.planes.push_back({{0.0, 0.0, 12.0}, {0.0, 0.0, -1.0}, wall});
    return question;
}

probe::RenderQuestion drawFinePictureQuestion(std::uint64_t seed) {
    probe::RenderQuestion question = drawPictureQuestion(seed);
    question.settings.width = kFineWidth;
    question.settings.height = kFineWidth * 3 / 4;
    question.repetitions = kFineRepetitions;
    return question;
}

PictureVerdict judgePictures(const probe::RenderQuestion& asked, const probe::RenderAnswer& answer,
                             std::uint64_t seed) {
    const SeenPictures seen = readPictures(answer);
    if (seen.isFinite()) return Search{asked, seen, seed}.verdict();
    PictureVerdict verdict;
    verdict.finding = distributedFinding(kDofWrong, Severity::fail,
                                         "Colours were expected; some pixels hold a value that is "
                                         "no number.");
    return verdict;
}

bool followsPixels(const probe::RenderQuestion& asked, const probe::RenderAnswer& answer,
                   const Reading& reading, std::uint64_t seed) {
    const SeenPictures seen = readPictures(answer);
    Reading ofOwnLength = reading;
    ofOwnLength.pixelSpread *= static_cast<double>(kFineWidth) / kPictureWidth;
    if (!seen.isFinite()) return false;
    // Rough misfits settle it where they are this far apart.
    constexpr double kClearly = 1.25;
    const double rough = roughMisfit(asked, seen, reading, seed);
    const double roughOwn = roughMisfit(asked, seen, ofOwnLength, seed);
    if (std::max(rough, roughOwn) > kClearly * std::min(rough, roughOwn)) return rough < roughOwn;
    return candidateOf(asked, seen, reading, seed).misfit <=
           candidateOf(asked, seen, ofOwnLength, seed).misfit;
}

}  // namespace ticker::tasks
