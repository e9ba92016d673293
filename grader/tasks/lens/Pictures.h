#ifndef TICKER_TASKS_DISTRIBUTED_PICTURES_H
#define TICKER_TASKS_DISTRIBUTED_PICTURES_H

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

/// What came back: the repetitions of one question.
struct SeenPictures {
    std::vector<Plane> renders;
    Plane mean;
    Plane variance;          ///< between repetitions
    bool identical = false;  ///< all repetitions are one picture
    int width = 0;

    [[nodiscard]] bool isFinite() const;
};
[[nodiscard]] SeenPictures readPictures(const probe::RenderAnswer& answer);

/// The oracle's word for one reading, and how sure it is.
struct ExpectedPicture {
    Plane mean;
    Plane variance;  ///< of one render
    Plane error;     ///< squared, of `mean`
};
/// For judging: the error of the mean adds a 25th to the variance of the mean of all renders.
[[nodiscard]] ExpectedPicture expectedPicture(const probe::RenderQuestion& asked,
                                              const oracle::Reading& reading, std::uint64_t seed);
/// The mean under a mistake, as a template: its noise costs power, never validity.
[[nodiscard]] Plane mistakenPicture(const probe::RenderQuestion& asked,
                                    const oracle::Reading& reading, const oracle::Mistake& mistake,
                                    std::uint64_t seed);

/// How the pictures look in the direction of a difference (a matched filter; Neyman and Pearson
/// 1933).
struct Match {
    double z = 0.0;          ///< standard normal where there is no difference
    double amplitude = 0.0;  ///< 1 where the whole difference is there
    double spread = 0.0;  ///< variance of the filter's answers over repetitions, 1 where pixels are
                          ///< independent; 0 where there is one picture
};
[[nodiscard]] Match matchOf(const SeenPictures& seen, const ExpectedPicture& expected,
                            const Plane& mistaken);

/// Largest |z| of the sums over square tiles.
[[nodiscard]] double largestTileZ(const SeenPictures& seen, const ExpectedPicture& expected);

/// By how much pixels spread more over the repetitions than they should.
struct Excess {
    double z = 0.0;      ///< standard normal where they spread as expected; less is no fault
    double ratio = 1.0;  ///< seen variance / expected variance
};
[[nodiscard]] Excess excessVariance(const SeenPictures& seen, const ExpectedPicture& expected);

/// The share of the squared difference from the expected picture that is left when another picture
/// is expected: 0 where that one explains all.
[[nodiscard]] double unexplainedBy(const Plane& other, const SeenPictures& seen,
                                   const ExpectedPicture& expected);

/// The expected picture as much brighter or darker as fits best; nothing where it fits as it is, or
/// all is black.
[[nodiscard]] std::optional<Plane> rescaled(const SeenPictures& seen,
                                            const ExpectedPicture& expected);

/// Mean over the pixels of z^2: 1 for a right submission, whether or not its pixels' noise goes
/// together.
[[nodiscard]] double meanSquaredZ(const SeenPictures& seen, const ExpectedPicture& expected);

/// For people: where the pictures are too bright or too dark.
[[nodiscard]] Raster zMap(const SeenPictures& seen, const ExpectedPicture& expected);

}  // namespace ticker::tasks

#endif
