#ifndef TICKER_ORACLE_REPLICATE_H
#define TICKER_ORACLE_REPLICATE_H

#include <grader/oracle/Setup.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ticker::oracle {

/// Averages over the lens paths of one pixel.
struct PathMoments {
    std::array<double, 3> mean{};
    std::array<double, 6> second{};  ///< of the expected colour given the path: rr gg bb rg rb gb
    std::array<double, 6> noise{};   ///< covariance that shadow rays add on top of it

    PathMoments& operator+=(const PathMoments& other);
    PathMoments& operator*=(double factor);
};

/// One randomisation of a whole picture.
using Replicate = std::vector<PathMoments>;

/// Traces lens paths for every pixel of the picture.
/// @param number  Replicates of one seed with different numbers are independent.
/// @param counts  Lens paths for each pixel; powers of two spread best.
[[nodiscard]] Replicate replicate(const Setup& setup, std::uint64_t seed, std::uint64_t number,
                                  const std::vector<std::uint32_t>& counts);

}  // namespace ticker::oracle

#endif
