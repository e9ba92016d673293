// Slopes that are those of another column or row.
#include <grader/tasks/bump/places/OwnTexels.h>
#include <grader/tasks/bump/questions/RampLadder.h>
#include <grader/tests/tasks/bump/Asked.h>
#include <grader/tests/tasks/bump/Judging.h>
#include <grader/tests/tasks/bump/SomeReadings.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace ticker::tasks::bump {
namespace {

using selftest::Point;

/// The reference, which takes Bu so many rows, and Bv so many columns, aside.
selftest::NormalFunction aside(int columns, int rows) {
    return [=](const Point& point) {
        const Vector3 n = tests::smooth(point);
        const int width = point.map.width();
        const int height = point.map.height();
        const auto at = [&](int column, int row) {
            return point.map.at((column + width) % width, std::clamp(row, 0, height - 1));
        };
        const Parametrisation& map = tests::kParametrisation;
        const int column = std::min(static_cast<int>(map.u(n) * width), width - 1);
        const int row = std::min(static_cast<int>(map.v(n) * height), height - 1);
        const double alongU = at(column + 1, row + rows) - at(column, row + rows);
        const double alongV = at(column + columns, row + 1) - at(column + columns, row);
        return (n - map.alongU(n) * alongU - map.alongV(n) * alongV).normalised();
    };
}

TEST(OwnTexels, AreAskedForInEveryJudgement) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        EXPECT_EQ(tests::judge(aside(0, 0), seed).state, TaskState::passed) << seed;
        for (const int away : {2, 3, 5}) {
            const TaskJudgement columns = tests::judge(aside(away, 0), seed);
            EXPECT_EQ(tests::firstId(columns), "bump.wrong") << away << ", seed " << seed;
            EXPECT_NE(columns.reason.find("columns away"), std::string::npos) << columns.reason;
            const TaskJudgement rows = tests::judge(aside(0, -away), seed);
            EXPECT_EQ(tests::firstId(rows), "bump.wrong") << away << ", seed " << seed;
        }
    }
}

// The same normals as with the column rounded up, and a backward difference along u.
TEST(OwnTexels, MayBeOneAside) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        EXPECT_EQ(tests::judge(aside(1, 0), seed).state, TaskState::passed) << seed;
        EXPECT_EQ(tests::judge(aside(0, 1), seed).state, TaskState::passed) << seed;
    }
}

// Far below the limit, as the limit's derivation says.
TEST(ReadOwnTexels, AcceptsEveryReading) {
    const Ball ball{{0.5, -1.0, 20.0}, 12.0};
    Questionnaire questionnaire;
    Draws draws(4);
    const RampLadder ladder = planLadder(questionnaire, draws, ball, draws.directions(1000));
    const OwnTexelPlan plan = planOwnTexels(questionnaire, draws, ball);
    for (const selftest::Reading& reading : tests::someReadings()) {
        const Answers answers = tests::answersOf(questionnaire, [&](const Point& point) {
            return modelNormal(reading, selftest::Mistake::none, point);
        });
        const RampJudgement ramps = judgeLadder(ladder, answers).ramps;
        // Heights in whole bytes show no ramp but a coarse one; whole judgements ask for it.
        if (!ramps.response) continue;
        const OwnTexels read =
            readOwnTexels(plan, answers, ramps.fit->parametrisation, *ramps.response);
        EXPECT_LE(read.row.share, 0.2) << describe(reading);
        EXPECT_LE(read.column.share, 0.2) << describe(reading);
    }
}

}  // namespace
}  // namespace ticker::tasks::bump
