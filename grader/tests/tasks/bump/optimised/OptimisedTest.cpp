#include <grader/lab/selftest/BumpTables.h>
#include <grader/tasks/bump/JudgeBump.h>
#include <grader/tests/support/SlowRun.h>
#include <grader/tests/tasks/bump/optimised/Optimised.h>

#include <gtest/gtest.h>

namespace ticker::tests {
namespace {

using selftest::Point;
using selftest::Reading;

using NormalAt = raytracer::Vector3 (*)(const Reading&, const Point&);

/// Every 111th accepted reading, in a slow run every 37th, in both precisions.
void expectAllPass(NormalAt normalAt) {
    const std::vector<Reading> readings = selftest::acceptedReadings(1);
    for (std::size_t i = 0; i < readings.size(); i += isSlowRun() ? 37 : 111)
        for (const bool single : {false, true}) {
            Reading reading = readings[i];
            reading.singlePrecision = single;
            selftest::FunctionExaminee examinee(
                [&](const Point& point) { return normalAt(reading, point); });
            const TaskJudgement judgement = tasks::judgeBump(examinee, 100 + i);
            EXPECT_EQ(judgement.state, TaskState::passed)
                << selftest::describe(reading) << ": " << judgement.reason;
        }
}

TEST(OptimisedReadings, PassAtO0) {
    expectAllPass(normalAtO0);
}

TEST(OptimisedReadings, PassAtO3) {
    expectAllPass(normalAtO3);
}

TEST(OptimisedReadings, PassAtOfast) {
    expectAllPass(normalAtOfast);
}

}  // namespace
}  // namespace ticker::tests
