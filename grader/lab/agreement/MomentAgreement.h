#ifndef TICKER_CALIBRATE_MOMENTAGREEMENT_H
#define TICKER_CALIBRATE_MOMENTAGREEMENT_H

#include <grader/oracle/Oracle.h>

#include <raytracer/image/Image.h>

#include <functional>

namespace ticker::calibrate {

/// Agreement of independent renders with moments.
struct Agreement {
    double largestZ = 0.0;       ///< of a mean, over tiles of 6 x 6 pixels and channels
    double meanZ2 = 0.0;         ///< mean of the squares of the tiles' z: about 1
    int tiles = 0;               ///< number of z: tiles times channels
    double varianceZ = 0.0;      ///< of the whole picture's sum of squared deviations
    double varianceRatio = 0.0;  ///< observed / expected; 1 if both are zero
};

/// Compares independent renders with the moments of their distribution.
/// @param render  Called with 1, 2, ..., `renders` (at least 2). Returns linear colours, of the
///                moments' size.
[[nodiscard]] Agreement compare(const oracle::Moments& moments, int renders,
                                const std::function<raytracer::Image(int)>& render);

/// Largest z between two estimates of the same moments.
[[nodiscard]] double largestTileZ(const oracle::Moments& a, const oracle::Moments& b);

}  // namespace ticker::calibrate

#endif
