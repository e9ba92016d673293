#include <grader/tasks/shadows/answers/ShadowAims.h>
#include <grader/tasks/support/Draw.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace ticker::tasks {
namespace {

/// Aim points of a submission, in radii of the light.
using Aim = std::function<Vector3(Draw&)>;

Vector3 ball(Draw& draw) {
    return draw.direction() * std::cbrt(draw.between(0.0, 1.0));
}

Vector3 polarHelper(Draw& draw) {
    const double radius = draw.between(0.0, 1.0);
    const double theta = draw.between(0.0, std::numbers::pi);
    const double phi = draw.between(0.0, 2.0 * std::numbers::pi);
    return Vector3{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                   std::cos(theta)} *
           radius;
}

/// Aim points that depend on the direction from the point to the light.
using FacingAim = std::function<Vector3(Draw&, const Vector3&)>;

/// Three far lights, seen along the given directions; ten rays from 67 points each.
AimVerdict judgeFacing(const FacingAim& aim, const Vector3& axis, std::uint64_t seed) {
    Draw draw{seed, 1};
    const Perpendiculars sides = perpendicularsOf(axis);
    const double radius = 0.4;
    const double distance = 120.0;
    std::vector<ShadowQuestion> questions(3);
    std::vector<ShadowLog> logs(3);
    std::vector<const ShadowLog*> pointers;
    const Vector3 directions[3] = {axis, sides.first, sides.second};
    for (std::size_t i = 0; i < 3; ++i) {
        raytracer::SceneDescription& scene = questions[i].question.scene;
        const Vector3 light = directions[i] * distance;
        scene.pointLights.emplace_back(light, raytracer::ColourRGB{1.0}, 1.0);
        scene.planes.push_back({{}, directions[i], {}});
        logs[i].asked = &questions[i];
        for (int p = 0; p < 67; ++p) {
            PointLog point;
            point.lines.resize(1);
            for (int r = 0; r < 10; ++r) {
                AimLine line;
                line.direction = (light + aim(draw, directions[i]) * radius).normalised();
                line.foot = line.direction * light.dot(line.direction) - light;
                line.miss = line.foot.magnitude();
                point.lines[0].push_back(line);
            }
            logs[i].points.push_back(point);
        }
        pointers.push_back(&logs[i]);
    }
    return judgeAims(pointers);
}

AimVerdict judge(const Aim& aim, const Vector3& axis, std::uint64_t seed) {
    return judgeFacing([&](Draw& draw, const Vector3&) { return aim(draw); }, axis, seed);
}

/// A disc that faces the point; `radiusOf` maps a number between 0 and 1 to the distance from its
/// centre.
FacingAim facingDisc(const std::function<double(double)>& radiusOf, double squeezed = 1.0) {
    return [=](Draw& draw, const Vector3& axis) {
        const Perpendiculars sides = perpendicularsOf(axis);
        const double angle = draw.between(0.0, 2.0 * std::numbers::pi);
        const double radius = radiusOf(draw.between(0.0, 1.0));
        return (sides.first * std::cos(angle) + sides.second * (squeezed * std::sin(angle))) *
               radius;
    };
}

// Each accepted decision is wrong with a chance below 1e-9.
TEST(JudgeAims, AcceptsTheBallFromEveryDirection) {
    Draw draw{11, 2};
    for (int i = 0; i < 60; ++i) {
        const AimVerdict verdict = judge(ball, draw.direction(), 100 + static_cast<unsigned>(i));
        EXPECT_EQ(verdict.shape, AimShape::ball) << i;
        EXPECT_TRUE(verdict.sizeIsRight());
        EXPECT_FALSE(verdict.offCentre);
    }
}

// Along the line of sight feet have no extent: an axis there must not count as a wrong shape.
TEST(JudgeAims, AcceptsTheBallSeenAlongAnAxisAndNearIt) {
    for (const Vector3& axis :
         {Vector3{1.0, 0.0, 0.0}, Vector3{0.0, 1.0, 1e-3}.normalised(),
          Vector3{1.0, 1.0, 0.0}.normalised(), Vector3{0.001, 0.002, 1.0}.normalised()})
        EXPECT_EQ(judge(ball, axis, 5).shape, AimShape::ball);
}

TEST(JudgeAims, TellsTheOriginalsHelperFromTheBall) {
    Draw draw{12, 2};
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(judge(polarHelper, draw.direction(), 300 + static_cast<unsigned>(i)).shape,
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
        EXPECT_EQ(judge(poleUp, draw.direction(), seed).shape, AimShape::polarHelperY) << i;
        EXPECT_EQ(judge(poleAside, draw.direction(), seed).shape, AimShape::polarHelperX) << i;
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
            const AimVerdict verdict = judge(aim, draw.direction(), ++seed);
            EXPECT_EQ(verdict.shape, shape) << seed;
            EXPECT_TRUE(verdict.sizeIsRight()) << seed;
        }
    }
}

TEST(JudgeAims, CatchesALightTenPercentOff) {
    for (const double size : {0.9, 1.1}) {
        const auto aim = [&](Draw& draw) { return ball(draw) * size; };
        const AimVerdict verdict = judge(aim, Draw{13, 2}.direction(), 1);
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
        EXPECT_FALSE(judge(cube, axis, 1).shape);
        EXPECT_FALSE(judge(disc, axis, 2).shape);
        EXPECT_TRUE(judge(half, axis, 3).offCentre);
    }
}

// Over all points, ten rays of one point along one line fill the ball.
TEST(JudgeAims, WantsANewDirectionForEachRay) {
    for (const double low : {0.0, -1.0}) {
        int ray = 0;
        Vector3 side;
        const Aim line = [&](Draw& draw) {
            if (ray++ % 10 == 0) side = draw.direction();
            return side * draw.between(low, 1.0);
        };
        EXPECT_TRUE(judge(line, Draw{17, 2}.direction(), 5).together) << low;
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
        EXPECT_FALSE(judge(ball, axis, 6).together);
        EXPECT_FALSE(judge(polarHelper, axis, 7).together);
        EXPECT_FALSE(judge(antithetic, axis, 8).together);
    }
}

// A pool of ten aims says little about their distribution: no conclusion is allowed.
TEST(JudgeAims, FindsFewAimsThatComeAgain) {
    Draw pool{15, 2};
    std::vector<Vector3> aims;
    for (int i = 0; i < 10; ++i)
        aims.push_back(ball(pool));
    const Aim again = [&](Draw& draw) { return aims[static_cast<std::size_t>(draw.whole(0, 9))]; };
    const AimVerdict verdict = judge(again, Draw{16, 2}.direction(), 4);
    EXPECT_LE(verdict.distinct, 10U);
    EXPECT_TRUE(verdict.shape.has_value());
}

// The cone that a light subtends, as PBRT samples it, looks like an evenly filled disc. Each is
// refused with a chance below 1e-6.
TEST(JudgeAims, AcceptsEveryDensityBetweenTheHelpersAndTheSurfaces) {
    const std::vector<FacingAim> accepted{
        facingDisc([](double u) { return std::sqrt(u); }),
        facingDisc([](double u) { return std::pow(u, 0.7); }),
        facingDisc([](double u) { return std::pow(u, 0.4); }),
        [](Draw& draw, const Vector3&) {
            return draw.direction() * std::sqrt(draw.between(0.0, 1.0));
        },
        [](Draw& draw, const Vector3&) {
            return draw.direction() * std::pow(draw.between(0.0, 1.0), 0.7);
        },
        [](Draw& draw, const Vector3&) {
            return draw.direction() * std::pow(draw.between(0.0, 1.0), 0.15);
        }};
    Draw draw{21, 2};
    for (std::size_t i = 0; i < accepted.size(); ++i)
        for (unsigned seed = 500; seed < 512; ++seed) {
            const AimVerdict verdict = judgeFacing(accepted[i], draw.direction(), seed);
            EXPECT_TRUE(verdict.shapeIsRight()) << i << ' ' << seed;
            EXPECT_TRUE(verdict.sizeIsRight()) << i << ' ' << seed;
            EXPECT_FALSE(verdict.offCentre) << i << ' ' << seed;
        }
}

// Pairs of opposite lines are half as many independent ones.
TEST(JudgeAims, AcceptsOppositePairsOnAFacingDisc) {
    const FacingAim disc = facingDisc([](double u) { return std::pow(u, 0.45); });
    int ray = 0;
    Vector3 last;
    const FacingAim pairs = [&](Draw& draw, const Vector3& axis) {
        last = ray++ % 2 == 0 ? disc(draw, axis) : -last;
        return last;
    };
    Draw draw{22, 2};
    for (unsigned seed = 600; seed < 620; ++seed)
        EXPECT_TRUE(judgeFacing(pairs, draw.direction(), seed).shapeIsRight()) << seed;
}

// Missed with a chance below 1e-4 each.
TEST(JudgeAims, CatchesFacingShapesThatAreNoLight) {
    const std::vector<FacingAim> wrong{
        facingDisc([](double u) { return 0.9 * std::sqrt(u); }),
        facingDisc([](double u) { return 1.1 * std::sqrt(u); }),
        facingDisc([](double u) { return u * u * u; }),  // denser in the middle than the helper
        facingDisc([](double u) { return 0.5 + 0.45 * u; }),
        facingDisc([](double u) { return std::pow(u, 0.45); }, 0.33),
        [](Draw& draw, const Vector3&) {
            return draw.direction() * (0.9 * std::sqrt(draw.between(0.0, 1.0)));
        }};
    Draw draw{23, 2};
    for (std::size_t i = 0; i < wrong.size(); ++i)
        for (unsigned seed = 700; seed < 705; ++seed) {
            const AimVerdict verdict = judgeFacing(wrong[i], draw.direction(), seed);
            EXPECT_TRUE(verdict.tooWide || !verdict.shapeIsRight()) << i << ' ' << seed;
        }
}

/// Evenly over a shape that faces the point: `inside` tells which places from -1 to 1 belong to it.
FacingAim facingShape(const std::function<bool(double, double)>& inside) {
    return [inside](Draw& draw, const Vector3& axis) {
        const Perpendiculars sides = perpendicularsOf(axis);
        double x = 2.0;
        double y = 2.0;
        while (!inside(x, y)) {
            x = draw.between(-1.0, 1.0);
            y = draw.between(-1.0, 1.0);
        }
        return sides.first * x + sides.second * y;
    };
}

// None passes as a light, and a square does not pass as a square of another size. An ellipse may,
// because it resembles points that crowd at two poles.
TEST(JudgeAims, NamesWhatIsNotRoundByItsShape) {
    const std::vector<FacingAim> wrong{
        facingShape([](double x, double y) { return std::max(std::abs(x), std::abs(y)) < 0.7071; }),
        facingShape([](double x, double y) { return std::abs(x) + std::abs(y) < 1.0; }),
        facingShape([](double x, double y) { return x * x + 2.25 * y * y < 1.0; }),
        facingShape(
            [](double x, double y) { return 2.25 * (x + y) * (x + y) + (x - y) * (x - y) < 2.0; })};
    Draw draw{24, 2};
    for (std::size_t i = 0; i < wrong.size(); ++i)
        for (unsigned seed = 800; seed < 820; ++seed) {
            const AimVerdict verdict = judgeFacing(wrong[i], draw.direction(), seed);
            EXPECT_FALSE(verdict.shapeIsRight()) << i << ' ' << seed;
            EXPECT_FALSE(i < 2 && verdict.scaledShape) << i << ' ' << seed;
        }
}

// Points of a lattice turned by a random angle for each point: all ten lines of a point have the
// same direction when their angles are multiplied by four (the plastic number's lattice).
TEST(JudgeAims, AcceptsLinesThatDependOnEachOtherWithinAPoint) {
    int ray = 0;
    double turn = 0.0;
    const Aim lattice = [&](Draw& draw) {
        if (ray % 10 == 0) turn = draw.between(0.0, 1.0);
        const double n = ray++ % 10;
        const double angle = 2.0 * std::numbers::pi * (turn + n * 0.7548776662466927);
        const double z = draw.between(-1.0, 1.0);
        const double ring = std::sqrt(1.0 - z * z);
        return Vector3{ring * std::cos(angle), ring * std::sin(angle), z} *
               std::cbrt(draw.between(0.0, 1.0));
    };
    Draw draw{25, 2};
    for (unsigned seed = 900; seed < 920; ++seed)
        EXPECT_TRUE(judge(lattice, draw.direction(), seed).shapeIsRight()) << seed;
}

}  // namespace
}  // namespace ticker::tasks
