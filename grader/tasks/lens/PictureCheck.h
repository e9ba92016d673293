#ifndef TICKER_TASKS_DISTRIBUTED_PICTURECHECK_H
#define TICKER_TASKS_DISTRIBUTED_PICTURECHECK_H

#include <grader/probe/Question.h>
#include <grader/result/Finding.h>

#include <cstdint>
#include <optional>

namespace ticker::tasks {

/// A question whose pictures alone are judged, for code whose rays cannot be seen: a scene without
/// a light, at the handout's settings, no log.
/// @param onePicture  One large picture in place of several small ones: for code that repeats
/// itself.
[[nodiscard]] probe::RenderQuestion drawPictureQuestion(std::uint64_t seed,
                                                        bool onePicture = false);

/// What pictures say about T2.2, as z-scores: standard normal for a correct submission, but for the
/// approximation of sums of some hundred pixels by a normal law.
struct PictureVerdict {
    double apertureFactor = 1.0;  ///< the accepted reading that fits best
    double largestZ = 0.0;        ///< of all tests under that reading, without sign
    double excessVariance =
        0.0;  ///< z of the pixels' spread over the repetitions; high: too few rays
    double timesTheLimit = 0.0;      ///< the larger of both, each in units of its limit
    bool identical = false;          ///< all repetitions are one picture: a fixed seed
    std::optional<Finding> finding;  ///< what fits best, where a limit is passed
    /// It does not fit, but lens points that all pixels share may look so: a person should see it.
    bool ambiguous = false;
};

/// Compares with the oracle's mean and variance under each accepted aperture, by one matched filter
/// for each mistake that has a name (Neyman and Pearson 1933) and by tiles for the unknown.
[[nodiscard]] PictureVerdict judgePictures(const probe::RenderQuestion& asked,
                                           const probe::RenderAnswer& answer, std::uint64_t seed);

}  // namespace ticker::tasks

#endif
