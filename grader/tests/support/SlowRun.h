#ifndef TICKER_TESTS_SUPPORT_SLOWRUN_H
#define TICKER_TESTS_SUPPORT_SLOWRUN_H

#include <cstdlib>

namespace ticker::tests {

/// Whether `./tick guard slow` runs the test. Tests that try a share of many cases try a larger one
/// then.
[[nodiscard]] inline bool isSlowRun() {
    return std::getenv("TICKER_SLOW_TESTS") != nullptr;
}

}  // namespace ticker::tests

#endif
