#ifndef TICKER_METRICS_NOISEENERGY_H
#define TICKER_METRICS_NOISEENERGY_H

#include <grader/metrics/PictureView.h>

namespace ticker::metrics {

/// Total difference of two noisy pictures.
struct NoiseEnergy {
    double energy = 0.0;  ///< sum of squared tile scores; about `tiles` for renders of one scene
    int tiles = 0;

    /// An upper bound on the probability of such an energy, or a larger one, if both pictures are
    /// renders of the same thing by the same code.
    [[nodiscard]] double probability() const;
};

/// Tests whether two single renders, without further information, show the same thing.
///
/// The score of a tile is the sum over its pixels of the difference in brightness, divided by the
/// root of the sum of squares. If both pictures are renders of the same thing and pixels are
/// independent, each difference is positive or negative with equal probability, whatever the
/// distribution of the noise. For random signs the score s has E exp(t s^2) <= (1 - 2 t)^(-1/2)
/// (since E exp(x s) <= exp(x^2 / 2), with x normal), so Chernoff's bound for a chi-squared
/// variable holds for the sum over tiles.
///
/// @param tileSize  Side of a tile, pixels; tiles at the right and lower border may be smaller.
/// @throws raytracer::InputError as `requireSameSize`.
[[nodiscard]] NoiseEnergy noiseEnergy(const ByteView& reference, const ByteView& test,
                                      int tileSize = 8);

}  // namespace ticker::metrics

#endif
