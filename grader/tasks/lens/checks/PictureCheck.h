#ifndef TICKER_TASKS_LENS_CHECKS_PICTURECHECK_H
#define TICKER_TASKS_LENS_CHECKS_PICTURECHECK_H

#include <grader/oracle/Reading.h>
#include <grader/probe/Question.h>
#include <grader/result/Finding.h>
#include <grader/tasks/lens/checks/Expectations.h>

#include <cstdint>
#include <optional>

namespace ticker::tasks {

/// Result of T2.2's pictures as z-scores: standard normal for a correct submission, up to the
/// normal approximation of sums of some hundred pixels.
struct PictureVerdict {
    oracle::Reading reading;  ///< the accepted one that fits best
    double largestZ = 0.0;    ///< largest |z| of all tests under that reading
    double excessVariance =
        0.0;                     ///< z of the pixels' variance over repetitions; high: too few rays
    double timesTheLimit = 0.0;  ///< the larger of both, each in units of its limit
    bool identical = false;      ///< all repetitions are equal: a fixed seed
    std::optional<Finding> finding;  ///< the best explanation, if a limit is exceeded
    /// The pictures do not fit, but lens points that all pixels share could be the cause: needs
    /// review.
    bool ambiguous = false;
};

/// Compares with the oracle's mean and variance under each accepted reading (aperture,
/// antialiasing; for fixed lens points also the wider blur of a grid from edge to edge): by one
/// matched filter for each named mistake (Neyman and Pearson 1933), and by tiles for unknown ones.
/// @param expectations  Of the question that was answered.
[[nodiscard]] PictureVerdict judgePictures(Expectations& expectations,
                                           const probe::RenderAnswer& answer);
/// Judges smaller pixels, for focal points that look antialiased in larger ones. Fails if they are
/// off by a length of their own, or if they do not fit the reading of the larger pixels.
/// @param expectations  Of a question from `drawFinePictureQuestion`.
/// @param reading       Of the larger pixels. The filter need not be known.
[[nodiscard]] PictureVerdict judgeFinePictures(Expectations& expectations,
                                               const probe::RenderAnswer& answer,
                                               const oracle::Reading& reading);

}  // namespace ticker::tasks

#endif
