#ifndef TICKER_PIPELINE_FIT_H
#define TICKER_PIPELINE_FIT_H

#include <grader/exercise/Task.h>
#include <grader/metrics/Noise.h>
#include <grader/pipeline/SpecScenes.h>

#include <grader/probe/Question.h>

#include <vector>

namespace ticker::pipeline {

/// Largest misfit of a picture of few rays that leaves no doubt. Right ones have 0.72 with a
/// standard deviation of 0.03. A picture beyond the limit only costs another render, with the
/// handout's rays. A mistake with a misfit of 1.12 in the handout's picture has 1.06 or more in
/// this one: see docs/calibration.md.
inline constexpr double kMostMisfitOfFewRays = 0.95;

/// A submission's picture of a scene beside the expectation that fits it best.
struct Fit {
    const Expectation* expected = nullptr;
    metrics::Measured z;          ///< of each pixel; no values where the scene is not random
    std::vector<Misfit> misfits;  ///< of each expectation that was tried
    /// False if a picture with the handout's rays is needed to decide.
    bool isClear = true;
};

/// Compares a picture with the accepted readings' expectations. With few rays it compares sums over
/// tiles, in standard errors: a mistake that is spread over pixels adds up and noise does not, so
/// that both have about the same misfit as in the handout's picture.
/// @param rays  The number of rays that the picture was rendered with.
[[nodiscard]] Fit bestFit(const SpecScene& scene, const probe::RenderAnswer& answer, Rays rays);

}  // namespace ticker::pipeline

#endif
