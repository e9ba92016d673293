#ifndef TICKER_METRICS_NOISE_H
#define TICKER_METRICS_NOISE_H

#include <grader/metrics/View.h>

namespace ticker::metrics {

/// What many renders of one picture have in common: for each pixel the mean and the variance of a
/// single render, one channel, any unit.
struct Moments {
    double renders = 0.0;  ///< how many were averaged; above 1 for `welchTiles`
    Map mean;
    Map variance;
};

/// Tests of every tile of a picture against "equal but for noise".
struct TileTest {
    int tileSize = 0;  ///< pixels on a side; tiles at the right and lower border may be smaller
    Map score;         ///< one for each tile: signed, in standard errors, test minus reference
    Map probability;   ///< one for each tile: of such a score or a larger one by chance
    double smallest = 1.0;   ///< the smallest probability, corrected for the number of tiles
    double threshold = 0.0;  ///< a tile differs where its probability is below this
    int differing = 0;  ///< tiles that differ at the given false-alarm rate for the whole picture
};

/// Welch's t-test of the mean of each tile, for renders of which the variance was measured.
///
/// @param tileSize  1 or more.
/// @param alpha     Probability that equal renders show any differing tile (Bonferroni).
/// @see  Jung, Hanika, Dachsbacher, "Detecting Bias in Monte Carlo Renderers using Welch's t-test",
///       JCGT 9(2), 2020.
/// @throws raytracer::InputError as `requireSameSize`, and where `renders` or `tileSize` is too
/// small.
[[nodiscard]] TileTest welchTiles(const Moments& reference, const Moments& test, int tileSize,
                                  double alpha = 1e-6);

/// The same question for two single pictures of which nothing else is known. Where both are renders
/// of the same thing and pixels are independent, the difference of each pixel is as likely positive
/// as negative, so the sum over a tile, divided by the root of the sum of squares, exceeds x in
/// absolute value with a probability of at most 2 exp(-x^2 / 2), whatever the noise is like
/// (Hoeffding's inequality for random signs). The same holds for the products of neighbours in a
/// row or in a column, whose signs are random and independent, too: they find what is too bright
/// here and too dark beside it, such as an edge that moved. Channels are tested one by one, over
/// tiles of two sizes; the score of a tile is that of its worst test, with the sign of the
/// difference.
///
/// @param tileSize  Side of the tiles of the answer; the other size is four times that.
[[nodiscard]] TileTest noiseTiles(const ByteView& reference, const ByteView& test,
                                  int tileSize = 16, double alpha = 1e-6);

/// How much of what two pictures differ by cannot be noise of their own pixels: the sum of squared
/// differences, over what the pixels of both stand out from their neighbours (Immerkaer's operator,
/// which sees noise and fine detail, but no slopes and no straight edges). At most about 1 for two
/// renders with independent pixels; many times more where smooth pictures differ. 0 for equal ones.
/// @see  Immerkaer, "Fast Noise Variance Estimation", Computer Vision and Image Understanding
/// 64(2),
///       1996.
/// @throws raytracer::InputError as `requireSameSize`.
[[nodiscard]] double excessOverNoise(const ByteView& reference, const ByteView& test);

/// z-scores of each pixel, where a reference with its variance is known: (test - mean) / sqrt(
/// variance (1 / testRenders + 1 / reference.renders)). The number is the largest |z|.
///
/// @param floor  A variance below is taken to be this much, in squared units of the mean: honest
///               programs differ by rounding where there is no noise at all.
/// @throws raytracer::InputError as `requireSameSize`.
[[nodiscard]] Measured zMap(const Moments& reference, const Map& test, double testRenders,
                            double floor = 1e-6);

}  // namespace ticker::metrics

#endif
