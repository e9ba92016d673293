#ifndef TICKER_METRICS_NOISE_H
#define TICKER_METRICS_NOISE_H

#include <grader/metrics/PictureView.h>

namespace ticker::metrics {

/// Moments of renders of one picture: for each pixel the mean and the variance of a single render,
/// one channel, any unit.
struct Moments {
    double renders = 0.0;  ///< number of renders in the mean; above 1 for `welchTiles`
    Map mean;
    Map variance;
};

/// Tests of every tile against the null hypothesis "equal but for noise".
struct TileTest {
    int tileSize = 0;  ///< pixels on a side; tiles at the right and lower border may be smaller
    Map score;         ///< one for each tile: signed, in standard errors, test minus reference
    Map probability;   ///< one for each tile: of such a score or a larger one under the null
                       ///< hypothesis
    double smallest = 1.0;   ///< the smallest probability, corrected for the number of tests
    double threshold = 0.0;  ///< a tile differs if its probability is below this
    int differing = 0;  ///< tiles that differ at the given false-alarm rate for the whole picture
};

/// Welch's t-test of the mean of each tile, for renders whose variance was measured.
///
/// @param tileSize  1 or more.
/// @param alpha     Probability that equal renders show any differing tile (Bonferroni).
/// @see  Jung, Hanika, Dachsbacher, "Detecting Bias in Monte Carlo Renderers using Welch's t-test",
///         JCGT 9(2), 2020.
/// @throws raytracer::InputError as `requireSameSize`, and if `renders` or `tileSize` is too small.
[[nodiscard]] TileTest welchTiles(const Moments& reference, const Moments& test, int tileSize,
                                  double alpha = 1e-6);

/// Tests two single pictures whose variance is not known. If both are renders of the same thing and
/// pixels are independent, the difference of each pixel is positive or negative with equal
/// probability. So the sum over a tile, divided by the root of the sum of squares, exceeds x in
/// absolute value with a probability of at most 2 exp(-x^2 / 2), whatever the distribution of the
/// noise (Hoeffding's inequality for random signs). The same holds for the products of neighbours
/// in a row or column, whose signs are random and independent as well: they detect pairs of too
/// bright and too dark pixels, such as a moved edge. Channels are tested separately, on tiles of
/// two sizes; the score of a tile is that of its worst test, with the sign of the difference.
///
/// @param tileSize  Side of the tiles in the result; the other size is four times that.
/// @throws raytracer::InputError as `requireSameSize`, and if `tileSize` is too small.
[[nodiscard]] TileTest noiseTiles(const ByteView& reference, const ByteView& test,
                                  int tileSize = 16, double alpha = 1e-6);

/// The part of a difference that the pictures' own noise cannot explain: the sum of squared
/// differences, divided by the deviation of both pictures' pixels from their neighbours
/// (Immerkaer's operator, which responds to noise and fine detail, but not to slopes and straight
/// edges). At most about 1 for two renders with independent pixels; many times more if smooth
/// pictures differ. 0 for equal ones.
/// @see  Immerkaer, "Fast Noise Variance Estimation", Computer Vision and Image Understanding
///         64(2), 1996.
/// @throws raytracer::InputError as `requireSameSize`.
[[nodiscard]] double excessOverNoise(const ByteView& reference, const ByteView& test);

/// z-scores of each pixel, for a reference with known variance: (test - mean) / sqrt(
/// variance (1 / testRenders + 1 / reference.renders)), without the last term if
/// `reference.renders` is 0. The value is the largest |z|.
///
/// @param floor  Lower bound for the variance, in squared units of the mean: right programs differ
///         by rounding even without noise.
/// @throws raytracer::InputError as `requireSameSize`.
[[nodiscard]] Measured zMap(const Moments& reference, const Map& test, double testRenders,
                            double floor = 1e-6);

}  // namespace ticker::metrics

#endif
