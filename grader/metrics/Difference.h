#ifndef TICKER_METRICS_DIFFERENCE_H
#define TICKER_METRICS_DIFFERENCE_H

#include <grader/metrics/PictureView.h>

#include <cstddef>

namespace ticker::metrics {

// Metrics of each pixel alone. All throw raytracer::InputError as `requireSameSize`.

/// Root of the mean squared difference of bytes, 0 to 255, over all channels. The map holds the
/// value of each pixel.
[[nodiscard]] Measured rmse(const ByteView& reference, const ByteView& test);

/// Peak signal-to-noise ratio, decibels: 20 log10(255 / rmse); infinite for equal pictures. The map
/// is that of `rmse`.
[[nodiscard]] Measured psnr(const ByteView& reference, const ByteView& test);

/// Mean of (t - r)^2 / (r^2 + 0.01), for channels r and t from 0 to 1: differences in dark areas
/// count as much as in bright ones.
[[nodiscard]] Measured relativeMse(const ByteView& reference, const ByteView& test);

/// The largest difference of two bytes; the map holds each pixel's largest.
[[nodiscard]] Measured largestDifference(const ByteView& reference, const ByteView& test);

/// Number of pixels with a channel that differs by more than `tolerance`; the map holds 1 there.
[[nodiscard]] Measured differingPixels(const ByteView& reference, const ByteView& test,
                                       int tolerance = 0);

}  // namespace ticker::metrics

#endif
