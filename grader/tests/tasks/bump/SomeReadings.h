#ifndef TICKER_TESTS_TASKS_BUMP_SOMEREADINGS_H
#define TICKER_TESTS_TASKS_BUMP_SOMEREADINGS_H

#include <grader/lab/selftest/BumpReadings.h>
#include <grader/tests/support/SlowRun.h>

#include <cstddef>
#include <vector>

namespace ticker::tests {

/// The accepted readings, all of them in a slow run; else every 13th, which has each kind of gain,
/// sampling and difference.
[[nodiscard]] inline std::vector<selftest::Reading> someReadings() {
    constexpr std::size_t kStep = 13;
    const std::vector<selftest::Reading> all = selftest::acceptedReadings(1);
    std::vector<selftest::Reading> some;
    for (std::size_t i = 0; i < all.size(); i += isSlowRun() ? 1 : kStep)
        some.push_back(all[i]);
    return some;
}

}  // namespace ticker::tests

#endif
