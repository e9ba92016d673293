// The numbers in findings about aims, by hand.
#include <grader/tasks/shadows/answers/ShadowAims.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tests/tasks/shadows/ShadowByHand.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace ticker::tasks {
namespace {

/// The verdict on aims at three far lights at right angles, from 67 points with ten rays each.
/// `aim` returns aims in radii of the light.
AimVerdict judge(const std::function<Vector3(int ray, Draw&)>& aim) {
    ShadowByHand made;
    Draw draw{4, 8};
    const Vector3 foot{40.0, -30.0, 20.0};
    for (const Vector3& axis :
         {Vector3{1.0, 0.0, 0.0}, Vector3{0.0, 1.0, 0.0}, Vector3{0.0, 0.0, 1.0}}) {
        ShadowQuestion& asked = made.ask(ShadowQuestion::Purpose::farLight, {foot + axis * 120.0});
        asked.question.scene.planes[0] = {foot, axis, {}};
        for (int point = 0; point < 67; ++point) {
            made.point(foot);
            for (int ray = 0; ray < 10; ++ray)
                made.cast(foot + axis * 120.0 + aim(ray, draw) * 0.4, 0, {});
        }
    }
    return judgeAims(made.logs().farLight);
}

Vector3 inBall(int, Draw& draw) {
    return draw.direction() * std::cbrt(draw.between(0.0, 1.0));
}

TEST(AimsOf, AreTheLatticesPointsInOrder) {
    for (const AimShape shape : kAcceptedAimShapes)
        for (const int count : {3, 700}) {
            const std::vector<Vector3>& aims = aimsOf(shape, count);
            ASSERT_EQ(aims.size(), static_cast<std::size_t>(count));
            for (int i = 0; i < count; ++i)
                ASSERT_EQ(aims[static_cast<std::size_t>(i)], aimOf(shape, i));
            EXPECT_EQ(&aimsOf(shape, count), &aims);
        }
}

// A right shape exceeds each of the bounds with a chance below 1e-11.
TEST(JudgeAims, AcceptsEveryShapeUnderItsName) {
    const AimVerdict ball = judge(inBall);
    EXPECT_EQ(ball.shape, AimShape::ball);
    EXPECT_EQ(ball.lines, 2010U);
    EXPECT_EQ(ball.distinct, 2010U);
    EXPECT_NEAR(ball.widest, 0.99, 0.011);
    EXPECT_NEAR(ball.rimShare, 0.083, 0.03) << "(1 - 0.81)^1.5";
    EXPECT_LT(ball.lean, 0.06);
    EXPECT_TRUE(ball.sizeIsRight());
    EXPECT_FALSE(ball.offCentre || ball.together || ball.huddled);
    EXPECT_EQ(judge([](int, Draw& draw) { return draw.direction(); }).shape, AimShape::surface);
    EXPECT_EQ(judge([](int, Draw& d) { return d.direction() * d.between(0.0, 1.0); }).shape,
              AimShape::uniformRadius);
}

TEST(JudgeAims, MeasuresALightOfAnotherSize) {
    const auto times = [](double size) {
        return judge([=](int ray, Draw& draw) { return inBall(ray, draw) * size; });
    };
    const AimVerdict small = times(0.6);
    EXPECT_FALSE(small.shape);
    EXPECT_EQ(small.scaledShape, AimShape::ball);
    EXPECT_TRUE(small.tooNarrow);
    EXPECT_FALSE(small.tooWide || small.huddled);
    EXPECT_NEAR(small.widest, 0.6, 0.02);
    const AimVerdict large = times(1.5);
    EXPECT_TRUE(large.tooWide);
    EXPECT_FALSE(large.tooNarrow);
    EXPECT_EQ(large.scaledShape, AimShape::ball);
    EXPECT_TRUE(times(0.19).huddled);
    EXPECT_FALSE(times(0.21).huddled);
    EXPECT_FALSE(times(1.0 + 1e-3).tooWide) << "the bias may do that";
    EXPECT_TRUE(times(1.02).tooWide);
}

TEST(JudgeAims, SeesAimsThatLean) {
    const auto off = [](double by) {
        return judge([=](int ray, Draw& draw) {
            return inBall(ray, draw) * 0.5 + Vector3{1.0, 0.0, 0.0} * by;
        });
    };
    // Two of the three views see the whole offset, the third sees none of it.
    EXPECT_NEAR(off(0.3).lean, 0.2, 0.02);
    EXPECT_TRUE(off(0.3).offCentre) << "the bound for 2010 lines is 0.18";
    EXPECT_FALSE(off(0.25).offCentre);
}

TEST(JudgeAims, CountsAimsThatComeAgainOnce) {
    int next = 0;
    const AimVerdict verdict =
        judge([&](int, Draw&) { return aimOf(AimShape::ball, next++ % 50) * 0.7; });
    EXPECT_EQ(verdict.lines, 2010U);
    EXPECT_EQ(verdict.distinct, 50U);
    EXPECT_FALSE(verdict.together);
    const AimVerdict none = judgeAims({});
    EXPECT_EQ(none.lines, 0U);
    EXPECT_FALSE(none.shape);
}

TEST(AimOf, FillsEachShapeEvenly) {
    const auto moments = [](AimShape shape) {
        double radius = 0.0;
        Vector3 sum;
        double height = 0.0;
        for (int i = 0; i < 4096; ++i) {
            const Vector3 aim = aimOf(shape, i);
            radius += aim.magnitude() / 4096.0;
            height += std::abs(aim.z) / aim.magnitude() / 4096.0;
            sum += aim / 4096.0;
        }
        EXPECT_LT(sum.magnitude(), 0.01);
        return std::pair(radius, height);
    };
    const auto near = [](const std::pair<double, double>& seen, double radius, double height) {
        EXPECT_NEAR(seen.first, radius, 0.005);
        EXPECT_NEAR(seen.second, height, 0.005);
    };
    near(moments(AimShape::ball), 0.75, 0.5);
    near(moments(AimShape::surface), 1.0, 0.5);
    near(moments(AimShape::uniformRadius), 0.5, 0.5);
    near(moments(AimShape::polarHelper), 0.5, 2.0 / 3.14159265);
}

}  // namespace
}  // namespace ticker::tasks
