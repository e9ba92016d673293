// Steep slopes beside gentle ones, and the map's edges, on submissions made by hand.
#include <grader/lab/selftest/BumpReadings.h>
#include <grader/tasks/bump/questions/MapEdges.h>
#include <grader/tasks/bump/questions/Proportion.h>
#include <grader/tests/tasks/bump/Asked.h>
#include <grader/tests/tasks/bump/Judging.h>
#include <grader/tests/tasks/bump/SomeReadings.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace ticker::tasks::bump {
namespace {

using selftest::Point;

const Ball kBall{{0.0, 0.0, 20.0}, 12.0};

Proportion proportionOf(const selftest::NormalFunction& function) {
    Questionnaire questionnaire;
    Draws draws(4);
    const ProportionPlan plan = planProportion(questionnaire, draws, kBall);
    return readProportion(plan, tests::answersOf(questionnaire, function));
}

double growthOf(const selftest::NormalFunction& function) {
    return proportionOf(function).growth;
}

MapEdges edgesOf(const selftest::NormalFunction& function, const Parametrisation& parametrisation) {
    Questionnaire questionnaire;
    Draws draws(4);
    const EdgePlan plan = planEdges(questionnaire, draws, kBall);
    return readEdges(plan, tests::answersOf(questionnaire, function), parametrisation);
}

selftest::NormalFunction modelOf(const selftest::Reading& reading) {
    return [reading](const Point& point) {
        return selftest::modelNormal(reading, selftest::Mistake::none, point);
    };
}

/// The texel at the rounded-down place, forward differences, u = 0 at the back; `heightAt` returns
/// the height at any column and row, also beyond the edge.
template <typename HeightAt>
selftest::NormalFunction withHeights(HeightAt heightAt) {
    return [heightAt](const Point& point) {
        const Parametrisation parametrisation({0.0, 1.0, 0.0}, 0.5, false);
        const Vector3 n = tests::smooth(point);
        const int column = static_cast<int>(parametrisation.u(n) * point.map.width());
        const int row = std::min(static_cast<int>(parametrisation.v(n) * point.map.height()),
                                 point.map.height() - 1);
        const double here = heightAt(point.map, column, row);
        const double onU = heightAt(point.map, column + 1, row) - here;
        const double onV = heightAt(point.map, column, row + 1) - here;
        return (n - onU * parametrisation.alongU(n) - onV * parametrisation.alongV(n)).normalised();
    };
}

selftest::NormalFunction beyondTheEdge(double height) {
    return withHeights([height](const selftest::HeightMap& map, int column, int row) {
        const bool inside = column < map.width() && row < map.height();
        return inside ? map.at(column, row) : height;
    });
}

TEST(ReadProportion, IsExactWhateverTheStrengthOfAProportionalTilt) {
    for (const double strength : {0.01, 1.0, 20.0}) {
        selftest::Reading reading;
        reading.strength = strength;
        EXPECT_NEAR(growthOf(modelOf(reading)), ProportionPlan::kTimes, 1e-3) << strength;
    }
}

TEST(ReadProportion, IsGoodForEveryAcceptedReading) {
    const std::vector<selftest::Reading> readings = tests::someReadings();
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const double growth = growthOf(modelOf(readings[i]));
        EXPECT_NEAR(growth, ProportionPlan::kTimes, 2.0) << describe(readings[i]);
    }
}

TEST(ReadProportion, SeesSlopesThatAreCutOffOrBent) {
    const auto bent = [](auto bend) {
        return tests::inProportion(Parametrisation({0.0, 1.0, 0.0}, 0.5, false),
                                   [bend](const tests::Place& at, const Point&) {
                                       const auto factor = [&](double slope) {
                                           return slope == 0.0 ? 1.0 : bend(slope) / slope;
                                       };
                                       return std::pair(factor(at.alongU), factor(at.alongV));
                                   });
    };
    EXPECT_FALSE(
        Proportion{growthOf(bent([](double b) { return std::clamp(b, -0.1, 0.1); }))}.good());
    EXPECT_FALSE(Proportion{growthOf(bent([](double b) { return std::tanh(20.0 * b); }))}.good());
    EXPECT_FALSE(Proportion{growthOf(bent([](double b) { return std::cbrt(b); }))}.good());
    EXPECT_TRUE(
        Proportion{growthOf(bent([](double b) { return std::clamp(b, -2.0, 2.0); }))}.good())
        << "steeper than maps are";
}

/// Turns the normal down the slope by the angle `angleOf(slope)`.
selftest::NormalFunction turnedBy(double (*angleOf)(double)) {
    return [angleOf](const Point& point) {
        selftest::Reading reading;
        const Vector3 n = tests::smooth(point);
        const Vector3 tilt =
            tiltOf(selftest::modelNormal(reading, selftest::Mistake::none, point), n);
        const double slope = tilt.magnitude();
        if (slope == 0.0) return n;
        const double angle = angleOf(slope);
        return n * std::cos(angle) + tilt * (std::sin(angle) / slope);
    };
}

// The normal n - slope is exactly right: before it is normalised, its component along n is 1.
TEST(ReadProportion, FindsEveryAcceptedReadingAboveTheHorizon) {
    const std::vector<selftest::Reading> readings = tests::someReadings();
    for (const selftest::Reading& reading : readings)
        EXPECT_LT(proportionOf(modelOf(reading)).pastHorizon, 0.005) << describe(reading);
}

TEST(ReadProportion, SeesNormalsThatAreTurnedByTheSlopeItself) {
    const Proportion turned = proportionOf(turnedBy([](double slope) { return slope; }));
    EXPECT_GT(turned.pastHorizon, 0.06);
    EXPECT_FALSE(turned.staysAboveHorizon());
    EXPECT_EQ(proportionOf(turnedBy([](double slope) { return std::atan(slope); })).pastHorizon,
              0.0);
    EXPECT_EQ(proportionOf(turnedBy([](double slope) { return 0.3 * slope; })).pastHorizon, 0.0);
}

TEST(ReadProportion, FindsEveryAcceptedReadingTheSameAtEveryHeight) {
    for (const selftest::Reading& reading : tests::someReadings()) {
        const Proportion proportion = proportionOf(modelOf(reading));
        EXPECT_TRUE(proportion.isSameAtEveryHeight())
            << describe(reading) << ": " << proportion.brightOverDark;
        const double least = isDisplaced(reading) ? 0.2 : 0.95;
        EXPECT_GT(proportion.brightOverDark, least) << describe(reading);
        EXPECT_LT(proportion.brightOverDark, 1.05) << describe(reading);
    }
}

/// The displaced surface 1 + h of a unit sphere is exact, whatever the sphere's radius.
TEST(ReadProportion, AcceptsTheDisplacedUnitSphere) {
    selftest::Reading reading;
    reading.gain = selftest::Reading::Gain::displacedUnit;
    reading.strength = 40.0;
    EXPECT_TRUE(proportionOf(modelOf(reading)).isSameAtEveryHeight());
}

TEST(ReadProportion, SeesHeightsThroughAPowerOrARoot) {
    const auto withPower = [](double power) {
        return proportionOf(withHeights([power](const selftest::HeightMap& map, int c, int r) {
            return std::pow(map.at(c % map.width(), std::min(r, map.height() - 1)), power);
        }));
    };
    for (const double power : {1.5, 2.0, 2.2, 6.0, 0.5, 1.0 / 2.2, 0.2})
        EXPECT_FALSE(withPower(power).isSameAtEveryHeight()) << power;
    EXPECT_NEAR(withPower(1.0).brightOverDark, 1.0, 1e-3);
    EXPECT_GT(withPower(2.0).brightOverDark, 30.0);
    EXPECT_LT(withPower(0.5).brightOverDark, 1.0 / 6.5);
}

TEST(ReadProportion, SeesACurveThatIsSteepOrFlatInTheMiddle) {
    const auto under = [](auto curve) {
        return proportionOf(withHeights([curve](const selftest::HeightMap& map, int c, int r) {
            const double height = map.at(c % map.width(), std::min(r, map.height() - 1));
            return 5.0 * curve(height / 5.0);
        }));
    };
    EXPECT_FALSE(under([](double h) { return h * h * (3.0 - 2.0 * h); }).isSameAtEveryHeight());
    EXPECT_FALSE(
        under([](double h) { return 0.5 + 4.0 * std::pow(h - 0.5, 3.0); }).isSameAtEveryHeight());
}

TEST(JudgeBump, SaysHowManyTimesBrightTexelsTilt) {
    for (const selftest::Mistake mistake :
         {selftest::Mistake::powered, selftest::Mistake::squared, selftest::Mistake::rooted}) {
        const TaskJudgement judgement = tests::judge({}, mistake);
        ASSERT_EQ(tests::firstId(judgement), "bump.wrong");
        EXPECT_NE(judgement.reason.find("The same slope tilts the normal"), std::string::npos)
            << judgement.reason;
        EXPECT_NE(judgement.findings.front().hint.find("no power, root"), std::string::npos);
    }
}

TEST(ReadProportion, IsGoodForASmoothSphere) {
    EXPECT_EQ(proportionOf(tests::smooth).brightOverDark, 1.0);
    EXPECT_EQ(growthOf(tests::smooth), ProportionPlan::kTimes);
}

TEST(ReadEdges, AreGoodForEveryAcceptedReading) {
    for (const selftest::Reading& reading : tests::someReadings()) {
        if (reading.top != selftest::Reading::Top::y) continue;
        const Parametrisation parametrisation({0.0, 1.0, 0.0}, reading.uOrigin, reading.mirrored);
        const MapEdges edges = edgesOf(modelOf(reading), parametrisation);
        EXPECT_LE(edges.seam, 0.6 * MapEdges::kMost) << describe(reading);
        EXPECT_LE(edges.endRows, 0.6 * MapEdges::kMost) << describe(reading);
    }
}

TEST(ReadEdges, SeeAnyHeightThatTheMapDoesNotHave) {
    const Parametrisation parametrisation({0.0, 1.0, 0.0}, 0.5, false);
    for (const double height : {0.0, 2.5, -1.0}) {
        const MapEdges edges = edgesOf(beyondTheEdge(height), parametrisation);
        EXPECT_FALSE(edges.goodSeam()) << height << ": " << edges.seam;
        EXPECT_FALSE(edges.goodEndRows()) << height << ": " << edges.endRows;
    }
}

TEST(ReadEdges, TellTheSeamFromTheLastRow) {
    const Parametrisation parametrisation({0.0, 1.0, 0.0}, 0.5, false);
    const MapEdges rows =
        edgesOf(withHeights([](const selftest::HeightMap& map, int column, int row) {
                    return row < map.height() ? map.at(column % map.width(), row) : 0.0;
                }),
                parametrisation);
    EXPECT_TRUE(rows.goodSeam());
    EXPECT_FALSE(rows.goodEndRows());
}

TEST(JudgeBump, OnlyWarnsOfAWallAtThePoles) {
    const TaskJudgement judgement =
        tests::judge(withHeights([](const selftest::HeightMap& map, int column, int row) {
            return row < map.height() ? map.at(column % map.width(), row) : 0.0;
        }));
    EXPECT_EQ(judgement.state, TaskState::passed);
    ASSERT_FALSE(judgement.findings.empty());
    EXPECT_EQ(judgement.findings.back().id, "bump.wrong");
    EXPECT_EQ(judgement.findings.back().severity, Severity::warn);
}

}  // namespace
}  // namespace ticker::tasks::bump
