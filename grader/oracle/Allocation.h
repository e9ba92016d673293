#ifndef TICKER_ORACLE_ALLOCATION_H
#define TICKER_ORACLE_ALLOCATION_H

#include <cstdint>
#include <vector>

namespace ticker::oracle {

/// Noise of each pixel, as estimated by a pilot run.
struct PilotNoise {
    int width = 0;
    int height = 0;
    std::uint32_t paths = 1;       ///< in each replicate of the pilot
    std::vector<double> variance;  ///< of one replicate's mean, all channels together
    /// The variance of a mean of n paths falls like n^-decay: 1 for random points; about 1.9 for
    /// lattices in such pictures (measured).
    double decay = 1.0;
};

/// Number of paths that each pixel gets in every one of `replicates` replicates, so that the
/// variances of the final means add up to `target` at the least cost: powers of two from `least` to
/// `most`.
///
/// The variances are smoothed over neighbours first, since a pilot's estimate for one pixel is
/// rough. With `even` all pixels get the same number.
[[nodiscard]] std::vector<std::uint32_t> allocated(const PilotNoise& pilot, int replicates,
                                                   double target, std::uint32_t least,
                                                   std::uint32_t most, bool even);

}  // namespace ticker::oracle

#endif
