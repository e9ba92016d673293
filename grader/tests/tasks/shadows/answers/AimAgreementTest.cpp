#include <grader/tasks/shadows/answers/AimAgreement.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tests/tasks/shadows/ShadowByHand.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace ticker::tasks {
namespace {

using Purpose = ShadowQuestion::Purpose;

/// Whether the rays of points under a far light go together. `aim` returns where each ray passes
/// the light's centre, in radii.
bool together(int points, int rays, const std::function<Vector3(int ray, Draw&)>& aim) {
    ShadowByHand made;
    made.ask(Purpose::farLight, {{0.0, 120.0, 0.0}});
    Draw draw{3, 5};
    for (int i = 0; i < points; ++i) {
        made.point();
        for (int ray = 0; ray < rays; ++ray)
            made.cast(Vector3{0.0, 120.0, 0.0} + aim(ray, draw) * 0.4);
    }
    return goTogether({&made.last()}, {{0.0, 1.0, 0.0}});
}

Vector3 anywhere(int, Draw& draw) {
    return draw.direction();
}

/// Aims on a circle, at most `spread` radians to either side of one direction, a new one for every
/// point.
std::function<Vector3(int, Draw&)> withinAngle(double spread) {
    return [spread, middle = 0.0](int ray, Draw& draw) mutable {
        if (ray == 0) middle = draw.between(0.0, 7.0);
        const double angle = middle + draw.between(-spread, spread);
        return Vector3{std::cos(angle), 0.0, std::sin(angle)};
    };
}

TEST(GoTogether, WantsRaysThatGoOneWayOrLieAlongOneLine) {
    EXPECT_FALSE(together(200, 10, anywhere));
    EXPECT_TRUE(together(200, 10, withinAngle(0.3)));
    double turn = 0.0;
    EXPECT_TRUE(together(200, 10, [&](int ray, Draw& draw) {
        if (ray == 0) turn = draw.between(0.0, 7.0);
        return Vector3{std::cos(turn), 0.0, std::sin(turn)} * (ray % 2 == 0 ? 1.0 : -1.0);
    })) << "to both sides";
}

// The mean resultant of angles within s of a middle is sin(s) / s; ten of them agree in direction
// by 0.1 + 0.9 (sin(s) / s)^2, and in line by that of twice the angle. The bound over 400 points is
// 0.125 + 0.178 and 0.4 + 0.178.
TEST(GoTogether, HoldsOnlyBeyondTheAgreementThatChanceGives) {
    EXPECT_TRUE(together(400, 10, withinAngle(1.75)));   // 0.38 in direction, 0.12 in line
    EXPECT_FALSE(together(400, 10, withinAngle(2.15)));  // 0.24 and 0.13
    const auto alongLine = [](double spread) {
        return [inner = withinAngle(spread)](int ray, Draw& draw) mutable {
            return inner(ray, draw) * (ray % 2 == 0 ? 1.0 : -1.0);
        };
    };
    EXPECT_TRUE(together(400, 10, alongLine(0.6)));   // 0.65 in line
    EXPECT_FALSE(together(400, 10, alongLine(0.9)));  // 0.36
}

TEST(GoTogether, SaysNothingOfFewPointsOrFewRays) {
    EXPECT_TRUE(together(100, 8, withinAngle(0.1)));
    EXPECT_FALSE(together(99, 8, withinAngle(0.1)));
    EXPECT_FALSE(together(100, 7, withinAngle(0.1)));
    EXPECT_FALSE(together(200, 10, [](int, Draw&) { return Vector3{}; })) << "all to the centre";
}

TEST(SamplesOf, LeavesOutAnExtraRayToTheCentre) {
    ShadowByHand made;
    made.ask(Purpose::farLight);
    PointLog& point = made.point();
    made.castArc(9);
    made.cast({0.0, 6.0, 0.0});
    EXPECT_EQ(samplesOf(point, made.last().settings()).size(), 10U) << "as many as asked for";
    made.cast({0.2, 6.0, 0.1});
    EXPECT_EQ(samplesOf(point, made.last().settings()).size(), 10U) << "the central one is extra";
    point.lines[0][0].miss = 1.005e-4;  // the ray starts 1e-4 from the point
    EXPECT_EQ(samplesOf(point, made.last().settings()).size(), 9U);
    point.lines[0][0].miss = 1.02e-4;
    EXPECT_EQ(samplesOf(point, made.last().settings()).size(), 10U);
    point.lines[0][0].origin = {0.0, 0.5, 0.0};
    point.lines[0][0].miss = 1.6e-3;
    EXPECT_EQ(samplesOf(point, made.last().settings()).size(), 10U) << "no bias allows that";
}

TEST(SamplesOf, MeasuresTheBiasFromThePointWhereverItLies) {
    ShadowByHand made;
    made.ask(Purpose::farLight, {{3.0, 6.0, 2.0}});
    PointLog& point = made.point({3.0, 0.0, 2.0});
    made.castArc(11);
    point.lines[0][0].miss = 0.9e-4;
    EXPECT_EQ(samplesOf(point, made.last().settings()).size(), 10U);
    point.lines[0][0].miss = 1.2e-4;
    EXPECT_EQ(samplesOf(point, made.last().settings()).size(), 11U) << "more than the bias of 1e-4";
}

}  // namespace
}  // namespace ticker::tasks
