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

/// What a scene should look like.
struct Expectation {
    raytracer::ByteImage picture;
    /// Of the brightness of one student render, linear; without values where nothing is random.
    metrics::Moments brightness;
};

/// Half-width / dofAmount.
inline constexpr std::array kAcceptedApertures{1.0, 0.5};

/// Accepted readings of option 2 that look different: the handout's light through each accepted
/// aperture first, then readings of the light that change shadows most.
[[nodiscard]] std::vector<oracle::Reading> acceptedReadings();

/// One number for each pixel, linear.
[[nodiscard]] metrics::Map brightnessOf(int width, int height,
                                        const std::vector<raytracer::ColourRGB>& pixels);

/// Option 1's scenes, through a pinhole.
[[nodiscard]] Expectation expectPinhole(const raytracer::SceneDescription& scene,
                                        const raytracer::RenderSettings& settings);
/// Option 2's; some 300 ms of CPU.
[[nodiscard]] Expectation expectLens(const raytracer::SceneDescription& scene,
                                     const raytracer::RenderSettings& settings,
                                     const oracle::Reading& reading);

}  // namespace ticker::pipeline

#endif
