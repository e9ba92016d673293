// The questions about the eye, the poles and small maps, for every accepted reading.
#include <grader/lab/selftest/BumpReadings.h>
#include <grader/tasks/bump/Examination.h>
#include <grader/tests/support/SlowRun.h>
#include <grader/tests/tasks/bump/Asked.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace ticker::tasks::bump {
namespace {

/// All of the reading's answers, with the parametrisation that its ramps show.
Examination examinationOf(const selftest::Reading& reading, std::uint64_t seed) {
    const MainPlan plan = planMain(seed);
    return examine(plan, tests::answersOf(plan.questionnaire, [&](const selftest::Point& point) {
                       return selftest::modelNormal(reading, selftest::Mistake::none, point);
                   }));
}

// The limits are 0.1 for `elsewhere`, 0.7 for `caps`, 0.6 and 0.12 for `fewTexels`, 0.3 for
// `belts`. These bounds leave room for readings that the model does not have.
void expectRoom(const Examination& examination) {
    EXPECT_LE(examination.elsewhere.changed, 0.03);
    if (!examination.caps || !examination.fewTexels) return;  // heights in whole bytes
    EXPECT_LE(examination.belts->wrong, 0.05);
    EXPECT_GE(examination.caps->alongU, 0.9);
    EXPECT_GE(examination.caps->alongV, 0.9);
    EXPECT_GE(examination.fewTexels->alongU, 0.8);
    EXPECT_GE(examination.fewTexels->alongV, 0.8);
    EXPECT_GE(examination.fewTexels->beforeLastColumn, 0.3);
    EXPECT_GE(examination.fewTexels->beforeLastRow, 0.3);
}

TEST(Places, AcceptedReadingsAreFarFromTheLimits) {
    // In a quick run every 150th, another one under each seed.
    const std::size_t step = tests::isSlowRun() ? 1 : 150;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const std::vector<selftest::Reading> readings = selftest::acceptedReadings(seed);
        for (std::size_t i = seed; i < readings.size(); i += step) {
            SCOPED_TRACE(describe(readings[i]));
            expectRoom(examinationOf(readings[i], seed));
        }
    }
}

}  // namespace
}  // namespace ticker::tasks::bump
