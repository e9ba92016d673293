#ifndef TICKER_TESTS_MAINTICK_MISTAKEROWS_H
#define TICKER_TESTS_MAINTICK_MISTAKEROWS_H

#include <grader/tasks/maintick/Hits.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::tasks::maintick {

inline constexpr Distance kMiss = std::nullopt;

/// What a mistake answers along each of some rays. A table has a row for each known mistake, in
/// the same order.
template <std::size_t Rays>
struct MistakeRow {
    std::string_view name;  ///< for tests alone
    std::array<Distance, Rays> answers;
};

/// The mistake that the row of this name is about.
template <std::size_t Rays>
const HitMistake& mistakeNamed(std::string_view name, const std::vector<MistakeRow<Rays>>& rows,
                               std::span<const HitMistake> mistakes) {
    const auto row = std::ranges::find(rows, name, &MistakeRow<Rays>::name);
    if (row == rows.end() || rows.size() != mistakes.size())
        throw std::invalid_argument{"no row \"" + std::string{name} + "\", or no row for each"};
    return mistakes[static_cast<std::size_t>(row - rows.begin())];
}

inline void expectDistance(const Distance& given, const Distance& wanted) {
    ASSERT_EQ(given.has_value(), wanted.has_value());
    if (!wanted) return;
    if (std::isnan(*wanted))
        EXPECT_TRUE(std::isnan(*given));
    else
        EXPECT_NEAR(*given, *wanted, 1e-9);
}

}  // namespace ticker::tasks::maintick

#endif
