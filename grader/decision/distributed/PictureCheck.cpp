#include <grader/decision/distributed/Draw.h>
#include <grader/decision/distributed/FindingText.h>
#include <grader/decision/distributed/PictureCheck.h>

#include <grader/oracle/Oracle.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace ticker::decision {
namespace {

using oracle::Mistake;
using oracle::Moments;
using oracle::Reading;

constexpr int kWidth = 24;
constexpr int kHeight = 18;
constexpr int kRepetitions = 8;
constexpr int kTile = 6;

// One number for each pixel: three weights of which no scene colour is blind to.
constexpr ColourRGB kWeights{0.35, 0.4, 0.25};

// Legitimate differences that no variance shows: single precision, other orders of summation.
constexpr double kVarianceFloor = 1e-8;

struct Suspect {
    const char* id;
    const char* seen;
    Reading reading;
    Mistake mistake;
};

Suspect suspect(const char* id, const char* seen, double factor, const Mistake& mistake) {
    Reading reading;
    reading.apertureFactor = factor;
    return {id, seen, reading, mistake};
}

std::vector<Suspect> suspectsFor(double factor) {
    std::vector<Suspect> suspects;
    const auto with = [](auto change) {
        Mistake mistake;
        change(mistake);
        return mistake;
    };
    suspects.push_back(suspect("dof.none", "everything is sharp", factor,
                               with([](Mistake& m) { m.aperture = Mistake::Aperture::none; })));
    suspects.push_back(suspect("dof.focal-distance",
                               "the sharp surface is a ball around the eye, not a plane", factor,
                               with([](Mistake& m) { m.focalByDistance = true; })));
    for (const double focal : {0.85, 1.2})
        suspects.push_back(suspect("dof.focal-plane", "another plane is sharp", factor,
                                   with([&](Mistake& m) { m.focalFactor = focal; })));
    suspects.push_back(
        suspect("dof.off-centre", "things out of focus are shifted", factor, with([](Mistake& m) {
                    m.lensOffsetX = 1.0;
                    m.lensOffsetY = 1.0;
                })));
    suspects.push_back(suspect("dof.off-centre", "things out of focus are shifted", 0.5 * factor,
                               with([](Mistake& m) {
                                   m.lensOffsetX = 1.0;
                                   m.lensOffsetY = 1.0;
                               })));
    suspects.push_back(suspect("dof.disc", "the blur has the shape of a disc", factor,
                               with([](Mistake& m) { m.aperture = Mistake::Aperture::disc; })));
    for (const double size : {0.7, 1.4})
        suspects.push_back(suspect("dof.aperture-size", "the blur has another size", size * factor,
                                   with([](Mistake&) {})));
    suspects.push_back(suspect("dof.not-averaged", "the picture is too bright or too dark", factor,
                               with([](Mistake& m) { m.pixelScale = 1.1; })));
    return suspects;
}

double weighed(const ColourRGB& colour) {
    return kWeights.r * colour.r + kWeights.g * colour.g + kWeights.b * colour.b;
}

/// A picture as one number for each pixel.
using Plane = std::vector<double>;

Plane meanOf(const Moments& moments) {
    Plane plane;
    for (const ColourRGB& colour : moments.mean)
        plane.push_back(weighed(colour));
    return plane;
}

struct Seen {
    Plane mean;
    Plane variance;  // between repetitions
    std::size_t renders = 0;
    bool identical = false;
};

Seen readPictures(const probe::RenderAnswer& answer) {
    Seen seen;
    seen.renders = answer.images.size();
    seen.identical = std::all_of(answer.images.begin(), answer.images.end(),
                                 [&](const auto& image) { return image == answer.images.front(); });
    const std::size_t pixels = answer.images.front().size();
    seen.mean.assign(pixels, 0.0);
    seen.variance.assign(pixels, 0.0);
    const auto count = static_cast<double>(seen.renders);
    for (const auto& image : answer.images)
        for (std::size_t i = 0; i < pixels; ++i)
            seen.mean[i] += weighed(image[i]) / count;
    for (const auto& image : answer.images)
        for (std::size_t i = 0; i < pixels; ++i)
            seen.variance[i] += std::pow(weighed(image[i]) - seen.mean[i], 2.0) / (count - 1.0);
    return seen;
}

/// The oracle's word for one reading, and how sure it is.
struct Expected {
    Plane mean;
    Plane variance;  // of one render
    Plane error;     // squared, of `mean`
};

Expected expectedFor(const probe::RenderQuestion& asked, const Reading& reading,
                     const Mistake& mistake, std::uint64_t seed, double share) {
    oracle::Precision precision;
    precision.share = share;
    precision.renders = kRepetitions;
    const Moments moments =
        oracle::Oracle{asked.scene, asked.settings, reading, mistake}.moments(seed, precision);
    Expected expected{meanOf(moments), {}, {}};
    for (std::size_t i = 0; i < moments.mean.size(); ++i) {
        const ColourRGB& error = moments.meanError[i];
        expected.variance.push_back(moments.covariance[i].along(kWeights));
        // Channels of one pixel go together; their errors are added as if they were one.
        expected.error.push_back(std::pow(kWeights.r * std::sqrt(error.r) +
                                              kWeights.g * std::sqrt(error.g) +
                                              kWeights.b * std::sqrt(error.b),
                                          2.0));
    }
    return expected;
}

/// Variance of (seen mean - expected mean) at one pixel.
double varianceAt(const Seen& seen, const Expected& expected, std::size_t i) {
    const double renders = seen.identical ? 1.0 : static_cast<double>(seen.renders);
    return expected.variance[i] / renders + expected.error[i] + kVarianceFloor;
}

double matchedZ(const Seen& seen, const Expected& expected, const Plane& template_) {
    double sum = 0.0;
    double variance = 0.0;
    for (std::size_t i = 0; i < template_.size(); ++i) {
        const double v = varianceAt(seen, expected, i);
        const double weight = template_[i] / v;
        sum += weight * (seen.mean[i] - expected.mean[i]);
        variance += weight * weight * v;
    }
    return variance > 0.0 ? sum / std::sqrt(variance) : 0.0;
}

double largestTileZ(const Seen& seen, const Expected& expected) {
    double largest = 0.0;
    for (int ty = 0; ty < kHeight; ty += kTile)
        for (int tx = 0; tx < kWidth; tx += kTile) {
            double sum = 0.0;
            double variance = 0.0;
            for (int y = ty; y < ty + kTile; ++y)
                for (int x = tx; x < tx + kTile; ++x) {
                    const auto i = static_cast<std::size_t>(y * kWidth + x);
                    sum += seen.mean[i] - expected.mean[i];
                    variance += varianceAt(seen, expected, i);
                }
            largest = std::max(largest, std::abs(sum) / std::sqrt(variance));
        }
    return largest;
}

// Pixels spread over the repetitions as the oracle's variance says; less is no fault (stratified
// samples), more is: fewer rays, or rays that are shared. Fourth moments are those of normal laws,
// since each pixel is a mean of fifty rays.
double excessVarianceZ(const Seen& seen, const Expected& expected) {
    if (seen.identical) return 0.0;
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < seen.variance.size(); ++i) {
        if (expected.variance[i] < 100.0 * kVarianceFloor) continue;
        sum += seen.variance[i] / expected.variance[i] - 1.0;
        count += 1.0;
    }
    const double freedom = static_cast<double>(seen.renders) - 1.0;
    return count > 0.0 ? sum / std::sqrt(2.0 * count / freedom) : 0.0;
}

Plane difference(const Plane& a, const Plane& b) {
    Plane result(a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        result[i] = a[i] - b[i];
    return result;
}

Raster zMap(const Seen& seen, const Expected& expected) {
    Raster raster;
    raster.title = "Where the picture is too dark (blue) or too bright (red), full at 8 sigma";
    raster.width = kWidth;
    raster.height = kHeight;
    raster.colours = Raster::Colours::diverging;
    for (std::size_t i = 0; i < seen.mean.size(); ++i) {
        const double z =
            (seen.mean[i] - expected.mean[i]) / std::sqrt(varianceAt(seen, expected, i));
        raster.values.push_back(static_cast<float>(std::clamp(z / 8.0, -1.0, 1.0)));
    }
    return raster;
}

// What the whole picture is too bright or too dark by, where that explains nearly all; else 0.
double commonFactor(const Seen& seen, const Expected& expected) {
    double products = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < seen.mean.size(); ++i) {
        products += seen.mean[i] * expected.mean[i];
        squares += expected.mean[i] * expected.mean[i];
    }
    const double factor = products / squares;
    double unexplained = 0.0;
    double difference = 0.0;
    for (std::size_t i = 0; i < seen.mean.size(); ++i) {
        unexplained += std::pow(seen.mean[i] - factor * expected.mean[i], 2.0);
        difference += std::pow(seen.mean[i] - expected.mean[i], 2.0);
    }
    return std::abs(factor - 1.0) > 0.01 && unexplained < 0.1 * difference ? factor : 0.0;
}

struct Trial {
    PictureVerdict verdict;
    double total = 0.0;  // squares of all z: how badly the reading fits
};

Finding findingOf(const char* id, const std::string& seen, const std::string& runnerUp, double z) {
    Finding finding = distributedFinding(
        id, Severity::fail,
        "The picture was compared with what the handout's steps give, since the rays cannot be "
        "seen: " +
            seen + ".");
    finding.evidence.emplace_back("z", z);
    if (!runnerUp.empty()) finding.evidence.emplace_back("runnerUp", runnerUp);
    return finding;
}

Trial tryReading(const probe::RenderQuestion& asked, const Seen& seen, double factor,
                 std::uint64_t seed, double limit) {
    Reading reading;
    reading.apertureFactor = factor;
    const Expected expected = expectedFor(asked, reading, {}, seed, 0.02);
    Trial trial;
    PictureVerdict& verdict = trial.verdict;
    verdict.apertureFactor = factor;
    verdict.identical = seen.identical;
    verdict.excessVariance = excessVarianceZ(seen, expected);
    std::string best;
    std::string second;
    const char* bestId = "dof.wrong";
    double bestZ = 0.0;
    for (const Suspect& suspect : suspectsFor(factor)) {
        const Expected other = expectedFor(asked, suspect.reading, suspect.mistake, seed + 1, 0.2);
        const double z = matchedZ(seen, expected, difference(other.mean, expected.mean));
        trial.total += z * z;
        verdict.largestZ = std::max(verdict.largestZ, std::abs(z));
        if (z > bestZ) {
            second = bestId;
            bestZ = z;
            bestId = suspect.id;
            best = suspect.seen;
        }
    }
    const double tile = largestTileZ(seen, expected);
    trial.total += tile * tile;
    verdict.largestZ = std::max(verdict.largestZ, tile);
    const double scale = commonFactor(seen, expected);
    if (verdict.excessVariance > 20.0 * limit && scale == 0.0) {
        verdict.finding =
            findingOf("dof.shared-samples", "it changes as a whole from one time to the next", best,
                      verdict.excessVariance);
    } else if (verdict.largestZ > limit) {
        const bool named = bestZ > 0.35 * verdict.largestZ;
        verdict.finding = findingOf(scale != 0.0 ? "dof.not-averaged"
                                    : named      ? bestId
                                                 : "dof.wrong",
                                    named ? best : "it differs in a way that is not known", second,
                                    verdict.largestZ);
    } else if (verdict.excessVariance > 1.5 * limit) {
        // Sums of squares have heavier tails than sums.
        verdict.finding =
            findingOf("dof.too-few-rays", "it is noisier than that many rays for each pixel can be",
                      best, verdict.excessVariance);
    }
    if (verdict.finding) verdict.finding->rasters.push_back(zMap(seen, expected));
    return trial;
}

}  // namespace

probe::RenderQuestion drawPictureQuestion(std::uint64_t seed) {
    Draw draw{seed, 23};
    probe::RenderQuestion question;
    question.settings.width = kWidth;
    question.settings.height = kHeight;
    question.settings.seed = draw.word() >> 1U;
    question.repetitions = kRepetitions;
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

PictureVerdict judgePictures(const probe::RenderQuestion& asked, const probe::RenderAnswer& answer,
                             std::uint64_t seed, double limit) {
    const Seen seen = readPictures(answer);
    if (!std::all_of(seen.mean.begin(), seen.mean.end(),
                     [](double value) { return std::isfinite(value); })) {
        PictureVerdict verdict;
        verdict.finding = distributedFinding("dof.wrong", Severity::fail,
                                             "Colours were expected; some pixels hold a value that "
                                             "is no number.");
        return verdict;
    }
    const Trial full = tryReading(asked, seen, 1.0, seed, limit);
    if (!full.verdict.finding) return full.verdict;
    const Trial half = tryReading(asked, seen, 0.5, seed, limit);
    if (!half.verdict.finding || half.total < full.total) return half.verdict;
    return full.verdict;
}

}  // namespace ticker::decision
