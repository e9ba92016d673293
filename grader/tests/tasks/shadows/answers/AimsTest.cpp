#include <grader/tests/tasks/shadows/answers/AimsByHand.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace ticker::tasks {
namespace {

// Each of these decisions is wrong with a chance below 1e-9.
TEST(JudgeAims, AcceptsTheBallFromEveryDirection) {
    Draw draw{11, 2};
    for (int i = 0; i < 60; ++i) {
        const AimVerdict verdict =
            judgeAlong(ball, draw.direction(), 100 + static_cast<unsigned>(i));
        EXPECT_EQ(verdict.shape, AimShape::ball) << i;
        EXPECT_TRUE(verdict.sizeIsRight());
        EXPECT_FALSE(verdict.offCentre);
    }
}

// Feet have no extent along the line of sight: an axis of the world that lies there must not count
// as a wrong shape.
TEST(JudgeAims, AcceptsTheBallSeenAlongAnAxisAndNearIt) {
    for (const Vector3& axis :
         {Vector3{1.0, 0.0, 0.0}, Vector3{0.0, 1.0, 1e-3}.normalised(),
          Vector3{1.0, 1.0, 0.0}.normalised(), Vector3{0.001, 0.002, 1.0}.normalised()})
        EXPECT_EQ(judgeAlong(ball, axis, 5).shape, AimShape::ball);
}

TEST(JudgeAims, TellsTheOriginalsHelperFromTheBall) {
    Draw draw{12, 2};
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(judgeAlong(polarHelper, draw.direction(), 300 + static_cast<unsigned>(i)).shape,
                  AimShape::polarHelper);
}

// The axis of the poles is free: y points up in this world, z in textbooks.
TEST(JudgeAims, TellsTheOriginalsHelperWhateverItsPoles) {
    const Aim poleUp = [](Draw& draw) {
        const Vector3 aim = polarHelper(draw);
        return Vector3{aim.x, aim.z, aim.y};
    };
    const Aim poleAside = [](Draw& draw) {
        const Vector3 aim = polarHelper(draw);
        return Vector3{aim.z, aim.x, aim.y};
    };
    Draw draw{13, 2};
    for (int i = 0; i < 20; ++i) {
        const auto seed = 340 + static_cast<unsigned>(i);
        EXPECT_EQ(judgeAlong(poleUp, draw.direction(), seed).shape, AimShape::polarHelperY) << i;
        EXPECT_EQ(judgeAlong(poleAside, draw.direction(), seed).shape, AimShape::polarHelperX) << i;
    }
}

// Code that draws the polar angle evenly, but the radius as in a ball or constant, is nearer to an
// even density than the helper is.
TEST(JudgeAims, AcceptsEvenAnglesFromAnyPolesWhateverTheRadius) {
    Draw draw{14, 2};
    unsigned seed = 400;
    for (const AimShape shape : kAcceptedAimShapes) {
        if (shape.poles == AimShape::Poles::none) continue;
        for (int i = 0; i < 5; ++i) {
            const Aim aim = [&](Draw& numbers) { return aimOf(shape, numbers.whole(0, 1 << 20)); };
            const AimVerdict verdict = judgeAlong(aim, draw.direction(), ++seed);
            EXPECT_EQ(verdict.shape, shape) << seed;
            EXPECT_TRUE(verdict.sizeIsRight()) << seed;
        }
    }
}

TEST(JudgeAims, CatchesALightTenPercentOff) {
    for (const double size : {0.9, 1.1}) {
        const auto aim = [&](Draw& draw) { return ball(draw) * size; };
        const AimVerdict verdict = judgeAlong(aim, Draw{13, 2}.direction(), 1);
        EXPECT_TRUE(verdict.tooWide || !verdict.shape) << size;
        EXPECT_EQ(verdict.scaledShape, AimShape::ball) << size;
    }
}

TEST(JudgeAims, CatchesACubeADiscAndHalfABall) {
    const Aim cube = [](Draw& draw) {
        const double x = draw.between(-0.5, 0.5);
        const double y = draw.between(-0.5, 0.5);
        return Vector3{x, y, draw.between(-0.5, 0.5)};
    };
    const Aim disc = [](Draw& draw) {
        const double angle = draw.between(0.0, 2.0 * std::numbers::pi);
        const double radius = std::sqrt(draw.between(0.0, 1.0));
        return Vector3{radius * std::cos(angle), radius * std::sin(angle), 0.0};
    };
    const Aim half = [](Draw& draw) {
        const Vector3 point = ball(draw);
        return Vector3{point.x, std::abs(point.y), point.z};
    };
    Draw draw{14, 2};
    for (int i = 0; i < 10; ++i) {
        const Vector3 axis = draw.direction();
        EXPECT_FALSE(judgeAlong(cube, axis, 1).shape);
        EXPECT_FALSE(judgeAlong(disc, axis, 2).shape);
        EXPECT_TRUE(judgeAlong(half, axis, 3).offCentre);
    }
}

// If the ten rays of each point lie along one line, the rays of all points together still fill the
// ball.
TEST(JudgeAims, WantsANewDirectionForEachRay) {
    for (const double low : {0.0, -1.0}) {
        int ray = 0;
        Vector3 side;
        const Aim line = [&](Draw& draw) {
            if (ray++ % 10 == 0) side = draw.direction();
            return side * draw.between(low, 1.0);
        };
        EXPECT_TRUE(judgeAlong(line, Draw{17, 2}.direction(), 5).together) << low;
    }
}

// A false alarm has a chance below 1e-10 each.
TEST(JudgeAims, AcceptsRaysThatSpread) {
    int ray = 0;
    Vector3 last;
    const Aim antithetic = [&](Draw& draw) {
        last = ray++ % 2 == 0 ? ball(draw) : -last;
        return last;
    };
    Draw draw{18, 2};
    for (int i = 0; i < 10; ++i) {
        const Vector3 axis = draw.direction();
        EXPECT_FALSE(judgeAlong(ball, axis, 6).together);
        EXPECT_FALSE(judgeAlong(polarHelper, axis, 7).together);
        EXPECT_FALSE(judgeAlong(antithetic, axis, 8).together);
    }
}

// A pool of ten aims says little about their distribution: no conclusion is allowed.
TEST(JudgeAims, FindsFewAimsThatComeAgain) {
    Draw pool{15, 2};
    std::vector<Vector3> aims;
    for (int i = 0; i < 10; ++i)
        aims.push_back(ball(pool));
    const Aim again = [&](Draw& draw) { return aims[static_cast<std::size_t>(draw.whole(0, 9))]; };
    const AimVerdict verdict = judgeAlong(again, Draw{16, 2}.direction(), 4);
    EXPECT_LE(verdict.distinct, 10U);
    EXPECT_TRUE(verdict.shape.has_value());
}

}  // namespace
}  // namespace ticker::tasks
