#ifndef TICKER_TASKS_LENS_ANSWERS_PICTURES_H
#define TICKER_TASKS_LENS_ANSWERS_PICTURES_H

#include <grader/oracle/Reading.h>
#include <grader/probe/Question.h>
#include <grader/result/Finding.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace ticker::tasks {

/// A picture as one number for each pixel: a weighted sum of its channels, linear.
using Plane = std::vector<double>;

/// The repetitions of one answered question.
struct SeenPictures {
    std::vector<Plane> renders;
    Plane mean;
    Plane variance;          ///< between repetitions
    bool identical = false;  ///< all repetitions are equal
    int width = 0;

    [[nodiscard]] bool isFinite() const;
};
[[nodiscard]] SeenPictures readPictures(const probe::RenderAnswer& answer);

/// The oracle's expected picture for one reading.
struct ExpectedPicture {
    Plane mean;
    Plane variance;  ///< of one render
    Plane error;     ///< squared standard error of `mean`
};
/// How exact an expected picture is.
enum class Exactness {
    judging,  ///< the error of its mean adds a 25th to the variance of the mean of all renders
    rough     ///< an eighth of the least number of paths, for each pixel: to rule readings out
};
[[nodiscard]] ExpectedPicture expectedPicture(const probe::RenderQuestion& asked,
                                              const oracle::Reading& reading, std::uint64_t seed,
                                              Exactness exactness = Exactness::judging);
/// The mean picture under a mistake: the template of a matched filter. Its noise lowers the test's
/// power, but leaves it valid. Each pixel has the same number of paths, an eighth of the least
/// number that an expected picture of the same exactness has.
[[nodiscard]] Plane mistakenPicture(const probe::RenderQuestion& asked,
                                    const oracle::Reading& reading, const oracle::Mistake& mistake,
                                    std::uint64_t seed, Exactness exactness = Exactness::judging);

/// Matched filter for a difference between two pictures (Neyman and Pearson 1933).
struct Match {
    double z = 0.0;          ///< standard normal if there is no difference
    double amplitude = 0.0;  ///< 1 if the whole difference is there
    double spread = 0.0;  ///< variance of the filter's results over repetitions: 1 for independent
                          ///< pixels; 0 for a single picture
};
[[nodiscard]] Match matchOf(const SeenPictures& seen, const ExpectedPicture& expected,
                            const Plane& mistaken);

/// Largest |z| of the sums over square tiles.
[[nodiscard]] double largestTileZ(const SeenPictures& seen, const ExpectedPicture& expected);

/// How far the variance over repetitions exceeds the expected one.
struct Excess {
    double z = 0.0;  ///< standard normal if it equals the expected one; a low value is not a fault
    double ratio = 1.0;  ///< observed variance / expected variance
};
[[nodiscard]] Excess excessVariance(const SeenPictures& seen, const ExpectedPicture& expected);

/// Share of the squared difference from the expected picture that is left with `other` as the
/// expected picture; 0 if `other` explains everything.
[[nodiscard]] double unexplainedBy(const Plane& other, const SeenPictures& seen,
                                   const ExpectedPicture& expected);

/// The expected picture times the best fitting brightness factor; empty if the factor is 1 within
/// 0.01, or all is black.
[[nodiscard]] std::optional<Plane> rescaled(const SeenPictures& seen,
                                            const ExpectedPicture& expected);

/// Mean of z^2 over the pixels: 1 for a right submission, even with correlated noise.
[[nodiscard]] double meanSquaredZ(const SeenPictures& seen, const ExpectedPicture& expected);

/// A map of the pixels that are too bright or too dark, for the report.
[[nodiscard]] Raster zMap(const SeenPictures& seen, const ExpectedPicture& expected);

}  // namespace ticker::tasks

#endif
