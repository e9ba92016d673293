#include <grader/oracle/Oracle.h>
#include <grader/oracle/references/References.h>
#include <grader/pipeline/Expectation.h>

#include <raytracer/image/Image.h>
#include <raytracer/io/ImageWriter.h>

namespace ticker::pipeline {
namespace {

// An arbitrary constant, so that expectations are reproducible.
constexpr std::uint64_t kSeed = 1;
// Any weights will do, because only brightness is compared.
constexpr raytracer::ColourRGB kBrightness{0.25, 0.5, 0.25};

}  // namespace

metrics::Map brightnessOf(int width, int height, const std::vector<raytracer::ColourRGB>& pixels) {
    metrics::Map map{width, height, {}};
    for (const raytracer::ColourRGB& pixel : pixels)
        map.values.push_back(static_cast<float>(kBrightness.r * pixel.r + kBrightness.g * pixel.g +
                                                kBrightness.b * pixel.b));
    return map;
}

Expectation expectPinhole(const raytracer::SceneDescription& scene,
                          const raytracer::RenderSettings& settings) {
    return {raytracer::toBytes(oracle::renderPinholeWithOracle(scene, settings)), {}};
}

std::vector<oracle::Reading> acceptedReadings() {
    using oracle::LightShape;
    using oracle::PhongReading;
    std::vector<oracle::Reading> all;
    const auto add = [&](LightShape shape, PhongReading phong) {
        for (const double apertureFactor : kAcceptedApertures) {
            all.emplace_back();
            all.back().apertureFactor = apertureFactor;
            all.back().lightShape = shape;
            all.back().phong = phong;
        }
    };
    for (const LightShape shape : {LightShape::ball, LightShape::surface})
        for (const PhongReading phong :
             {PhongReading::central, PhongReading::perSample, PhongReading::perSampleDirection})
            add(shape, phong);
    return all;
}

Expectation expectLens(const raytracer::SceneDescription& scene,
                       const raytracer::RenderSettings& settings, const oracle::Reading& reading) {
    oracle::Precision precision;
    precision.share = 0.0;
    precision.rms = 5e-4;  // a tenth of a step of a byte
    const oracle::Moments moments =
        oracle::Oracle{scene, settings, reading}.moments(kSeed, precision);

    Expectation expected;
    raytracer::Image image{moments.width, moments.height};
    for (int y = 0; y < moments.height; ++y)
        for (int x = 0; x < moments.width; ++x)
            image.set(x, y, moments.mean[static_cast<std::size_t>(y * moments.width + x)]);
    expected.picture = raytracer::toBytes(image);
    expected.brightness.renders = 1.0 / moments.shareOfVariance(1);
    expected.brightness.mean = brightnessOf(moments.width, moments.height, moments.mean);
    expected.brightness.variance = {moments.width, moments.height, {}};
    for (const oracle::Covariance& covariance : moments.covariance)
        expected.brightness.variance.values.push_back(
            static_cast<float>(covariance.along(kBrightness)));
    return expected;
}

}  // namespace ticker::pipeline
