#include <grader/build/TimeBudget.h>

#include <gtest/gtest.h>

#include <chrono>

namespace ticker::build {
namespace {

TEST(TimeBudget, CutsTheLimitsOfARunToWhatIsLeft) {
    sandbox::Limits limits;
    limits.cpuSeconds = 20.0;
    limits.wallSeconds = 60.0;
    TimeBudget budget{{45.0, 90.0}};
    sandbox::Outcome outcome;
    outcome.cpuMs = 30'000.0;
    outcome.wallMs = 50'000.0;
    budget.spend(outcome);
    EXPECT_EQ(budget.cut(limits).cpuSeconds, 15.0);
    EXPECT_EQ(budget.cut(limits).wallSeconds, 40.0);
    EXPECT_FALSE(budget.isSpent());
    outcome.cpuMs = 14'500.0;
    budget.spend(outcome);
    EXPECT_TRUE(budget.isSpent());
}

sandbox::Outcome lasting(double seconds) {
    sandbox::Outcome outcome;
    outcome.wallMs = seconds * 1000.0;
    return outcome;
}

TEST(TimeBudget, CountsTheWallClockOfParallelRunsOnce) {
    sandbox::Limits limits;
    limits.wallSeconds = 90.0;
    TimeBudget budget{{45.0, 90.0}};
    const TimeBudget::Clock::time_point begin{std::chrono::hours{1}};
    const auto at = [&](int seconds) { return begin + std::chrono::seconds{seconds}; };

    budget.spend(lasting(10.0), at(10));  // 0 to 10
    budget.spend(lasting(30.0), at(35));  // 5 to 35
    budget.spend(lasting(36.0), at(36));  // 0 to 36
    EXPECT_EQ(budget.cut(limits).wallSeconds, 90.0 - 36.0);
    budget.spend(lasting(10.0), at(60));  // 50 to 60: the pause before it costs nothing
    EXPECT_EQ(budget.cut(limits).wallSeconds, 90.0 - 46.0);
    budget.spend(lasting(40.0), at(70));  // 30 to 70
    EXPECT_EQ(budget.cut(limits).wallSeconds, 90.0 - 70.0);
    EXPECT_FALSE(budget.isSpent());
    budget.spend(lasting(20.0), at(90));
    EXPECT_TRUE(budget.isSpent());
}

}  // namespace
}  // namespace ticker::build
