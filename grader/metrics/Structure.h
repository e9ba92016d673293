#ifndef TICKER_METRICS_STRUCTURE_H
#define TICKER_METRICS_STRUCTURE_H

#include <grader/metrics/PictureView.h>

namespace ticker::metrics {

// Metrics of each pixel with its neighbourhood, by the papers' formulas with OpenCV's filters.
// Their results are those of OpenCV's quality module, bit for bit. Both throw raytracer::InputError
// as `requireSameSize`.

/// Structural similarity, mean over pixels and channels: 1 for equal pictures. Border pixels count,
/// too.
/// @see  Z. Wang et al., "Image Quality Assessment: From Error Visibility to Structural
///       Similarity", IEEE TIP 13(4), 2004.
[[nodiscard]] Measured ssim(const ByteView& reference, const ByteView& test);

/// Deviation of gradient magnitude similarity: 0 for equal pictures. The number is the mean over
/// the channels; the map, of half the size, holds 1 where gradients are equal.
/// @see  W. Xue et al., "Gradient Magnitude Similarity Deviation", IEEE TIP 23(2), 2014.
[[nodiscard]] Measured gmsd(const ByteView& reference, const ByteView& test);

}  // namespace ticker::metrics

#endif
