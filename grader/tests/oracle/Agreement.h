#ifndef TICKER_TESTS_ORACLE_AGREEMENT_H
#define TICKER_TESTS_ORACLE_AGREEMENT_H

#include <grader/oracle/Oracle.h>

#include <raytracer/image/Image.h>

#include <functional>

namespace ticker::oracle::test {

/// How independent renders agree with moments.
struct Agreement {
    double largestZ = 0.0;   ///< of a mean, over tiles of 6 x 6 pixels and channels
    double meanZ2 = 0.0;     ///< mean of the squares of the tiles' z: about 1
    double varianceZ = 0.0;  ///< of the summed squared deviations of the whole picture
    double varianceRatio = 0.0;
};

/// @param render  Called with 1, 2, ..., `renders`.
[[nodiscard]] Agreement compare(const Moments& moments, int renders,
                                const std::function<raytracer::Image(int)>& render);

/// Likewise for two estimates of the same moments.
[[nodiscard]] double largestTileZ(const Moments& a, const Moments& b);

}  // namespace ticker::oracle::test

#endif
