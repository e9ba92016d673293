#include <grader/lab/calibrate/campaigns/PictureMethods.h>
#include <grader/metrics/Difference.h>
#include <grader/metrics/Flip.h>
#include <grader/metrics/Structure.h>
#include <grader/oracle/Oracle.h>

#include <raytracer/image/ToneCurve.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ticker::calibrate {
namespace {

using raytracer::ColourRGB;

std::vector<std::uint8_t> bytesOf(const std::vector<ColourRGB>& picture) {
    std::vector<std::uint8_t> bytes;
    for (const ColourRGB& colour : picture)
        for (const std::uint8_t byte : raytracer::toneMapped(colour))
            bytes.push_back(byte);
    return bytes;
}

// Two-sided p-value of a standard normal variable.
double twoSided(double z) {
    return std::erfc(std::abs(z) / std::numbers::sqrt2);
}

// Share of the channels that pass the z-test of Mitsuba 3 (src/render/tests/test_renders.py), which
// takes the variance of a sample to be at least 1e-4. Differences here: a student's picture is one
// sample of fifty rays, and the channels are red, green and blue in place of XYZ.
double shareThatPasses(const std::vector<ColourRGB>& mean, const std::vector<ColourRGB>& variance,
                       const std::vector<ColourRGB>& picture) {
    constexpr double kFloor = 1e-4 / 50.0;
    const double alpha = 1.0 - std::pow(0.99, 1.0 / static_cast<double>(picture.size()));
    std::size_t passing = 0;
    const auto passes = [&](double seen, double expected, double squared) {
        return twoSided((seen - expected) / std::sqrt(std::max(squared, kFloor))) > alpha;
    };
    for (std::size_t i = 0; i < picture.size(); ++i)
        for (double ColourRGB::*channel : {&ColourRGB::r, &ColourRGB::g, &ColourRGB::b})
            if (passes(picture[i].*channel, mean[i].*channel, variance[i].*channel)) ++passing;
    return static_cast<double>(passing) / (3.0 * static_cast<double>(picture.size()));
}

}  // namespace

PictureMethods::PictureMethods(const raytracer::SceneDescription& scene,
                               const raytracer::RenderSettings& settings)
    : width_(settings.width), height_(settings.height) {
    for (const double aperture : {1.0, 0.5})
        for (const oracle::LightShape shape :
             {oracle::LightShape::ball, oracle::LightShape::surface,
              oracle::LightShape::uniformRadius, oracle::LightShape::polarHelper}) {
            oracle::Reading reading;
            reading.apertureFactor = aperture;
            reading.lightShape = shape;
            oracle::Precision precision;
            precision.renders = 1;
            precision.share = 0.02;
            const oracle::Moments moments =
                oracle::Oracle{scene, settings, reading}.moments(1, precision);
            Reference reference{bytesOf(moments.mean), moments.mean, {}};
            for (const oracle::Covariance& covariance : moments.covariance)
                reference.variance.emplace_back(covariance.rr, covariance.gg, covariance.bb);
            references_.push_back(std::move(reference));
        }
}

PictureScores PictureMethods::score(const std::vector<ColourRGB>& picture) const {
    const std::vector<std::uint8_t> bytes = bytesOf(picture);
    const metrics::ByteView seen{width_, height_, bytes};
    PictureScores best{1e9, -1.0, 1e9, 0.0};
    for (const Reference& reference : references_) {
        const metrics::ByteView expected{width_, height_, reference.bytes};
        best.rmse = std::min(best.rmse, metrics::rmse(expected, seen).value);
        best.ssim = std::max(best.ssim, metrics::ssim(expected, seen).value);
        best.flip = std::min(best.flip, metrics::flip(expected, seen).value);
        best.zTest =
            std::max(best.zTest, shareThatPasses(reference.mean, reference.variance, picture));
    }
    return best;
}

}  // namespace ticker::calibrate
