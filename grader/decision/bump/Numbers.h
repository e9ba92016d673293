#ifndef TICKER_DECISION_BUMP_NUMBERS_H
#define TICKER_DECISION_BUMP_NUMBERS_H

#include <vector>

namespace ticker::decision::bump {

/// The value below which a share of the values lies; not-a-numbers do not count. Not a number
/// where nothing is left.
[[nodiscard]] double quantile(std::vector<double> values, double share);

[[nodiscard]] double median(std::vector<double> values);

}  // namespace ticker::decision::bump

#endif
