#ifndef TICKER_METRICS_COLOURDISTANCE_H
#define TICKER_METRICS_COLOURDISTANCE_H

#include <grader/metrics/PictureView.h>

namespace ticker::metrics {

/// A colour in CIE L*a*b*, white at L = 100.
struct Lab {
    double l = 0.0;
    double a = 0.0;
    double b = 0.0;
};

/// CIEDE2000 with all weights 1; a difference of 1 is just noticeable.
/// @see  G. Sharma, W. Wu, E. Dalal, "The CIEDE2000 Color-Difference Formula", Color Research and
///         Application 30(1), 2005; equation numbers in the code refer to it.
[[nodiscard]] double ciede2000(const Lab& first, const Lab& second);

/// CIEDE2000 of each pixel, and the mean.
/// @throws raytracer::InputError as `requireSameSize`.
[[nodiscard]] Measured ciede2000(const ByteView& reference, const ByteView& test);

}  // namespace ticker::metrics

#endif
