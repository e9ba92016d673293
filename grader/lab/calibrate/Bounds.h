#ifndef TICKER_CALIBRATE_BOUNDS_H
#define TICKER_CALIBRATE_BOUNDS_H

#include <cstddef>

namespace ticker::calibrate {

/// Upper bound of 95 % confidence on the chance of something that happened `hits` times in `count`
/// independent trials (Clopper and Pearson 1934): about 3 / count where it never did; 1 without
/// trials.
[[nodiscard]] double upperBound(std::size_t hits, std::size_t count);

}  // namespace ticker::calibrate

#endif
