#ifndef TICKER_TASKS_BUMP_NUMBERS_H
#define TICKER_TASKS_BUMP_NUMBERS_H

#include <functional>
#include <numbers>
#include <utility>
#include <vector>

namespace ticker::tasks::bump {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTurn = 2.0 * kPi;
inline constexpr double kDegrees = 180.0 / kPi;  ///< of one radian
/// A shorter tilt counts as none: ten times single precision's rounding.
inline constexpr double kLeastTilt = 5e-6;

/// The value below which a share of `share` of the values lies. NaNs are left out; NaN if no value
/// is left.
[[nodiscard]] double quantile(std::vector<double> values, double share);

[[nodiscard]] double median(std::vector<double> values);

/// Median of the lengths.
/// @param items     Vectors, or what has one.
/// @param vectorOf  The vector of an item.
template <class Items, class VectorOf = std::identity>
[[nodiscard]] double medianLength(const Items& items, VectorOf vectorOf = {}) {
    std::vector<double> lengths;
    lengths.reserve(items.size());
    for (const auto& item : items)
        lengths.push_back(std::invoke(vectorOf, item).magnitude());
    return median(std::move(lengths));
}

}  // namespace ticker::tasks::bump

#endif
