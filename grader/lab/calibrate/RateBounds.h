#ifndef TICKER_CALIBRATE_RATEBOUNDS_H
#define TICKER_CALIBRATE_RATEBOUNDS_H

#include <cstddef>

namespace ticker::calibrate {

/// Upper 95 % confidence bound on the probability of an event that happened `hits` times in `count`
/// independent trials (Clopper and Pearson 1934): about 3 / count without hits; 1 without trials.
[[nodiscard]] double upperBound(std::size_t hits, std::size_t count);

}  // namespace ticker::calibrate

#endif
