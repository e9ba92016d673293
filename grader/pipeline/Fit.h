#ifndef TICKER_PIPELINE_FIT_H
#define TICKER_PIPELINE_FIT_H

#include <grader/exercise/Task.h>
#include <grader/metrics/Noise.h>
#include <grader/pipeline/SpecScenes.h>

#include <grader/probe/Question.h>

#include <vector>

namespace ticker::pipeline {

/// A picture of few rays is clear up to here. Right ones have 0.72 with a standard deviation of
/// 0.03; those beyond are drawn again, no more. A mistake that has 1.12 in the handout's picture
/// has 1.06 or more in this one: see docs/calibration.md.
inline constexpr double kMostMisfitOfFewRays = 0.95;

/// A submission's picture of a scene beside the expectation that fits it best.
struct Fit {
    const Expectation* expected = nullptr;
    metrics::Measured z;          ///< of each pixel; no values where the scene is not random
    std::vector<Misfit> misfits;  ///< of each expectation that was tried
    /// Whether the picture needs no other with the handout's rays.
    bool isClear = true;
};

/// The misfit of a picture of few rays is that of sums over tiles, in standard errors: a mistake
/// that is spread over pixels adds up, noise does not, and so both have about the misfit that they
/// have in the handout's picture.
/// @param rays  Of the picture.
[[nodiscard]] Fit bestFit(const SpecScene& scene, const probe::RenderAnswer& answer, Rays rays);

}  // namespace ticker::pipeline

#endif
