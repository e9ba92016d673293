#include <grader/base/SplitMix.h>
#include <grader/base/Workers.h>

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace ticker {
namespace {

TEST(OnWorkers, CallsEachNumberOnceOnAnyNumberOfThreads) {
    for (const int workers : {0, 1, 3, 20}) {
        std::vector<std::atomic<int>> calls(10);
        onWorkers(workers, calls.size(), [&](std::size_t i) { ++calls[i]; });
        for (const std::atomic<int>& each : calls)
            EXPECT_EQ(each, 1) << workers << " workers";
    }
}

TEST(OnWorkers, BeginsNothingAfterAnErrorAndThrowsItAtTheEnd) {
    int calls = 0;
    EXPECT_THROW(onWorkers(1, 10,
                           [&](std::size_t i) {
                               ++calls;
                               if (i == 2) throw std::runtime_error("third");
                           }),
                 std::runtime_error);
    EXPECT_EQ(calls, 3);
}

TEST(SplitMix, GivesTheNumbersOfTheReferenceImplementation) {
    std::uint64_t state = 1234567;
    EXPECT_EQ(splitMix(state), 6457827717110365317U);
    EXPECT_EQ(splitMix(state), 3203168211198807973U);
}

}  // namespace
}  // namespace ticker
