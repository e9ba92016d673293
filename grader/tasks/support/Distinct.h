#ifndef TICKER_TASKS_SUPPORT_DISTINCT_H
#define TICKER_TASKS_SUPPORT_DISTINCT_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ticker::tasks {

/// How many of the values differ from each other. Sorting a list is several times faster than
/// filling a set.
template <class Value>
[[nodiscard]] std::size_t numberOfDifferent(std::vector<Value> values) {
    std::sort(values.begin(), values.end());
    return static_cast<std::size_t>(std::unique(values.begin(), values.end()) - values.begin());
}

}  // namespace ticker::tasks

#endif
