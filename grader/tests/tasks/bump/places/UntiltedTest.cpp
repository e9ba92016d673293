// Conditions that keep the normal smooth in some places.
#include <grader/lab/selftest/BumpReadings.h>
#include <grader/tasks/bump/places/Untilted.h>
#include <grader/tests/tasks/bump/Asked.h>
#include <grader/tests/tasks/bump/Judging.h>
#include <grader/tests/tasks/bump/SomeReadings.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace ticker::tasks::bump {
namespace {

using selftest::Point;

Untilted untiltedOf(const selftest::NormalFunction& function) {
    Questionnaire questionnaire;
    Draws draws(4);
    const UntiltedPlan plan = planUntilted(questionnaire, draws, {{0.5, -1.0, 20.0}, 12.0});
    return readUntilted(plan, tests::answersOf(questionnaire, function));
}

int columnOf(const Point& point) {
    const double u = tests::kParametrisation.u(tests::smooth(point));
    return std::min(static_cast<int>(u * point.map.width()), point.map.width() - 1);
}

int rowOf(const Point& point) {
    const double v = tests::kParametrisation.v(tests::smooth(point));
    return std::min(static_cast<int>(v * point.map.height()), point.map.height() - 1);
}

/// The right normals, smooth where a condition holds.
selftest::NormalFunction smoothWhere(
    std::function<bool(const Point&, const Vector3& tilted)> isSmooth) {
    return [isSmooth = std::move(isSmooth)](const Point& point) {
        const Vector3 tilted = selftest::modelNormal({}, selftest::Mistake::none, point);
        return isSmooth(point, tilted) ? tests::smooth(point) : tilted;
    };
}

TEST(ReadUntilted, IsGoodForEveryAcceptedReading) {
    for (const selftest::Reading& reading : tests::someReadings()) {
        const Untilted untilted = untiltedOf([&](const Point& point) {
            return selftest::modelNormal(reading, selftest::Mistake::none, point);
        });
        EXPECT_TRUE(untilted.good()) << describe(reading);
        const auto pairs = untilted.shares.begin() + static_cast<int>(Whereabouts::evenSteps);
        EXPECT_LT(*std::max_element(untilted.shares.begin(), pairs), 0.2) << describe(reading);
        EXPECT_LT(std::abs(pairs[0] - pairs[1]), 0.15) << describe(reading);
        for (const Whereabouts where : {Whereabouts::fewRows, Whereabouts::fewColumns})
            EXPECT_LT(untilted.shares.at(static_cast<std::size_t>(where)), 0.045)
                << describe(reading);
    }
}

TEST(ReadUntilted, SeesEachCondition) {
    const auto expectOnly = [](Whereabouts where, const selftest::NormalFunction& function) {
        const Untilted untilted = untiltedOf(function);
        // A condition on the place or on the eye holds at some points of maps of few texels, too.
        const std::size_t kinds = std::max(static_cast<std::size_t>(where) + 1,
                                           static_cast<std::size_t>(Whereabouts::fewRows));
        for (std::size_t i = 0; i < kinds; ++i)
            EXPECT_EQ(untilted.good(static_cast<Whereabouts>(i)),
                      i != static_cast<std::size_t>(where))
                << i << ": " << untilted.shares.at(i);
    };
    for (const double sine : {0.07, 0.1, 0.2})
        expectOnly(Whereabouts::nearPoles, smoothWhere([sine](const Point& point, const Vector3&) {
                       const Vector3 n = tests::smooth(point);
                       return std::hypot(n.x, n.z) < sine;
                   }));
    expectOnly(Whereabouts::atRim, smoothWhere([](const Point& point, const Vector3& tilted) {
                   const Vector3 toEye = -point.position;
                   return tests::smooth(point).dot(toEye) > 0.0 && tilted.dot(toEye) < 0.0;
               }));
    expectOnly(Whereabouts::farAway, smoothWhere([](const Point& point, const Vector3&) {
                   return point.position.magnitude() > 100.0;
               }));
    expectOnly(Whereabouts::smallSphere,
               smoothWhere([](const Point& point, const Vector3&) { return point.radius < 0.1; }));
    expectOnly(Whereabouts::onBlack, smoothWhere([](const Point& point, const Vector3&) {
                   return point.map.at(columnOf(point), rowOf(point)) == 0.0;
               }));
    for (const int left : {0, 4})
        expectOnly(Whereabouts::fewRows, smoothWhere([left](const Point& point, const Vector3&) {
                       return point.map.height() == 5 && rowOf(point) == left;
                   }));
    expectOnly(Whereabouts::fewColumns, smoothWhere([](const Point& point, const Vector3&) {
                   return point.map.width() == 5 && columnOf(point) == 4;
               }));
}

/// Whether the point lies in the left half of a map of this width, by which the tests know the
/// map.
bool isInLeftHalf(const Point& point, int width) {
    return point.map.width() == width && columnOf(point) < width / 2;
}

/// The right one of the two columns that code reads as a pair.
/// @param first  The left column of some pair: 0 or 1.
int rightOfPair(int column, int first) {
    const int pair = (column + first) / 2;
    return 2 * pair + 1 - first;
}

// Code that reads every other column sees no step within its pairs.
TEST(ReadUntilted, SeesColumnsThatAreReadInPairs) {
    constexpr int kWidth = 120;  // of the maps of evenSteps and oddSteps
    constexpr int kAnyRow = 3;   // the rows of their left halves are the same
    for (const int first : {0, 1}) {
        const Untilted untilted =
            untiltedOf(smoothWhere([first](const Point& point, const Vector3&) {
                if (!isInLeftHalf(point, kWidth)) return false;
                const int column = columnOf(point);
                return point.map.at(column, kAnyRow) ==
                       point.map.at(rightOfPair(column, first), kAnyRow);
            }));
        EXPECT_NE(untilted.good(Whereabouts::evenSteps), untilted.good(Whereabouts::oddSteps));
    }
}

TEST(ReadUntilted, SeesAConditionOnTheSumOfBothSlopes) {
    constexpr int kWidth = 280;  // of the map of onDiagonals
    const Untilted untilted = untiltedOf(smoothWhere(
        [](const Point& point, const Vector3&) { return isInLeftHalf(point, kWidth); }));
    EXPECT_FALSE(untilted.good(Whereabouts::onDiagonals));
}

TEST(JudgeBump, SaysWhereTheNormalStaysSmooth) {
    const TaskJudgement judgement = tests::judge(smoothWhere(
        [](const Point& point, const Vector3&) { return point.position.magnitude() > 100.0; }));
    ASSERT_EQ(tests::firstId(judgement), "bump.wrong");
    EXPECT_NE(judgement.reason.find("on a sphere that is far away"), std::string::npos)
        << judgement.reason;
}

TEST(ReadUntilted, JudgesASmoothSphereAsSmoothEverywhere) {
    EXPECT_EQ(untiltedOf(tests::smooth).shares.front(), 1.0);
}

}  // namespace
}  // namespace ticker::tasks::bump
