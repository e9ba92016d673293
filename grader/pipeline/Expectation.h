#ifndef TICKER_PIPELINE_EXPECTATION_H
#define TICKER_PIPELINE_EXPECTATION_H

#include <grader/metrics/Noise.h>
#include <grader/oracle/Reading.h>

#include <raytracer/base/RenderSettings.h>
#include <raytracer/image/ColourRGB.h>
#include <raytracer/io/ImageReader.h>
#include <raytracer/scene/SceneDescription.h>

#include <array>
#include <vector>

namespace ticker::pipeline {

/// The expected look of a scene.
struct Expectation {
    raytracer::ByteImage picture;
    /// Moments of the brightness of one student render, linear; empty if nothing is random.
    metrics::Moments brightness;
};

/// Half-width / dofAmount.
inline constexpr std::array kAcceptedApertures{1.0, 0.5};

/// Accepted readings of option 2 whose pictures differ: first the handout's light with each
/// accepted aperture, then the readings of the light that change shadows most.
[[nodiscard]] std::vector<oracle::Reading> acceptedReadings();

/// One number for each pixel, linear.
[[nodiscard]] metrics::Map brightnessOf(int width, int height,
                                        const std::vector<raytracer::ColourRGB>& pixels);

/// The expectation of an option 1 scene, through a pinhole.
[[nodiscard]] Expectation expectPinhole(const raytracer::SceneDescription& scene,
                                        const raytracer::RenderSettings& settings);
/// The expectation of an option 2 scene; takes about 300 ms of CPU time.
[[nodiscard]] Expectation expectLens(const raytracer::SceneDescription& scene,
                                     const raytracer::RenderSettings& settings,
                                     const oracle::Reading& reading);

}  // namespace ticker::pipeline

#endif
