#ifndef TICKER_METRICS_FLIPKERNELS_H
#define TICKER_METRICS_FLIPKERNELS_H

#include <vector>

namespace ticker::metrics {

/// One-dimensional kernels of odd length, to be applied along both axes.
using Kernel = std::vector<float>;

/// Contrast sensitivity filters: remove detail that an eye cannot resolve at a distance.
struct ContrastKernels {
    Kernel luminance;
    Kernel redGreen;
    /// The blue-yellow filter is the sum of two separable ones.
    Kernel blueYellowWide;
    Kernel blueYellowNarrow;
};

/// @see  section 4.1.1 and Table 1 of the paper that Flip.h names.
[[nodiscard]] ContrastKernels contrastKernels(double pixelsPerDegree);

/// A Gaussian and its first two derivatives, which detect edges and points.
struct FeatureKernels {
    Kernel smooth;
    Kernel edge;
    Kernel point;
};

/// @see  section 4.2.1 of the same paper.
[[nodiscard]] FeatureKernels featureKernels(double pixelsPerDegree);

}  // namespace ticker::metrics

#endif
