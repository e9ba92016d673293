#ifndef TICKER_METRICS_FLIP_H
#define TICKER_METRICS_FLIP_H

#include <grader/metrics/PictureView.h>

namespace ticker::metrics {

/// Pixels in one degree of a viewer's field of view.
[[nodiscard]] double pixelsPerDegree(double distanceInMetres, double monitorWidthInMetres,
                                     double monitorWidthInPixels);

/// A monitor 0.7 m wide with 3840 pixels, seen from 0.7 m: what the authors of FLIP use.
inline constexpr double kUsualPixelsPerDegree = 67.02064327658225;

/// LDR-FLIP: perceived difference between two pictures when a viewer flips between them.
///
/// @param pixelsPerDegree  From 4 to 500.
/// @return  The mean error and the error of each pixel, 0 (equal) to 1.
/// @throws raytracer::InputError as `requireSameSize`.
/// @see  P. Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", HPG 2020.
[[nodiscard]] Measured flip(const ByteView& reference, const ByteView& test,
                            double pixelsPerDegree = kUsualPixelsPerDegree);

/// Quartiles of the error, weighted by the error: errors below which a quarter, a half and three
/// quarters of the *sum* of all errors lie. They describe the larger errors, whatever share of the
/// picture has none.
struct WeightedQuartiles {
    double first = 0.0;
    double median = 0.0;
    double third = 0.0;
};
[[nodiscard]] WeightedQuartiles weightedQuartiles(const Map& errors);

}  // namespace ticker::metrics

#endif
