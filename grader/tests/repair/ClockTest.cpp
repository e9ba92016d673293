// Time that an explanation may take. The clock counts CPU time that the tests hand to it.
#include <grader/repair/Clock.h>
#include <grader/repair/TimedExaminee.h>

#include <gtest/gtest.h>

namespace ticker::repair {
namespace {

constexpr double kMore = 3'600'000.0;

/// Counts how often it is asked, and takes some time for each.
class Counting final : public probe::Examinee {
public:
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& /*questions*/) override {
        ++times;
        cpuMs += 0.75 * kMore;
        return {};
    }
    int times = 0;
    double cpuMs = 0.0;
};

sandbox::TimeLimits anHour() {
    return {kMore / 1000.0, kMore / 1000.0};
}

TEST(Clock, IsUsedUpByAllTimeAndNotByThatOfAStep) {
    Clock clock{anHour()};
    clock.endStepAt(0.5 * kMore);
    clock.add(Work::ask, 0.75 * kMore);
    EXPECT_TRUE(clock.isStepOver());
    EXPECT_FALSE(clock.isAllUsedUp());
    EXPECT_LE(clock.unusedMs(), 0.25 * kMore);
    clock.add(Work::prove, 0.25 * kMore);
    EXPECT_TRUE(clock.isAllUsedUp());
}

TEST(TimedExaminee, AsksNothingMoreWhenTheTimeIsUsedUp) {
    Clock clock{anHour()};
    Counting submission;
    TimedExaminee timed{submission, [&] { return submission.cpuMs; }, clock};
    for (int i = 0; i < 5; ++i)
        static_cast<void>(timed.ask({}));
    EXPECT_EQ(submission.times, 2);
    EXPECT_EQ(timed.ask({}).end.kind, probe::ProcessEnd::Kind::timedOut);
    EXPECT_EQ(clock.cpuMs(Work::prove), 1.5 * kMore);
}

}  // namespace
}  // namespace ticker::repair
