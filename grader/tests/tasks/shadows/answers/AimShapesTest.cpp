#include <grader/tasks/support/Bounds.h>
#include <grader/tests/support/SlowRun.h>
#include <grader/tests/tasks/shadows/answers/AimsByHand.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace ticker::tasks {
namespace {

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

// Lines in opposite pairs count as half as many independent ones.
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

// Perspective moves the middle of two opposite lines, and always to the same side where the aim
// points crowd at two poles. Each is refused with a chance below 1e-6.
TEST(JudgeAims, AcceptsOppositePairsOfTheOriginalsHelper) {
    int ray = 0;
    Vector3 last;
    const Aim pairs = [&](Draw& draw) {
        last = ray++ % 2 == 0 ? polarHelper(draw) : -last;
        return last;
    };
    Draw draw{26, 2};
    for (unsigned seed = 1000; seed < 1020; ++seed)
        EXPECT_TRUE(judgeAlong(pairs, draw.direction(), seed).shapeIsRight()) << seed;
}

// One random number for both the radius and the height: a surface like a trumpet, whose middle lies
// near the light's. In 2000 simulations the least sum of z |z|^2 was 67, and the limit is 50.
TEST(JudgeAims, CatchesRadiusAndHeightFromOneNumber) {
    const Aim trumpet = [](Draw& draw) {
        const double number = draw.between(0.0, 1.0);
        const double height = 1.0 - 2.0 * number;
        const double ring = std::sqrt(1.0 - height * height);
        const double angle = draw.between(0.0, 2.0 * std::numbers::pi);
        return Vector3{ring * std::cos(angle), height, ring * std::sin(angle)} * std::cbrt(number);
    };
    Draw draw{27, 2};
    for (unsigned seed = 1100; seed < 1120; ++seed)
        EXPECT_FALSE(judgeAlong(trumpet, draw.direction(), seed).shapeIsRight()) << seed;
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
    const unsigned end = tests::isSlowRun() ? 820 : 806;
    for (std::size_t i = 0; i < wrong.size(); ++i)
        for (unsigned seed = 800; seed < end; ++seed) {
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
        EXPECT_TRUE(judgeAlong(lattice, draw.direction(), seed).shapeIsRight()) << seed;
}

/// The largest gap between the distances from the centre of 4096 aims and their distribution.
double gapOf(AimShape shape, double (*within)(double radius)) {
    std::vector<double> radii;
    for (int i = 0; i < 4096; ++i)
        radii.push_back(std::min(1.0, aimOf(shape, i).magnitude()));
    std::ranges::sort(radii);
    return largestGap(radii, within);
}

TEST(AimOf, HasTheDistancesOfItsShape) {
    constexpr double kLattice = 0.005;
    EXPECT_LT(gapOf(AimShape::ball, [](double r) { return r * r * r; }), kLattice);
    EXPECT_LT(gapOf(AimShape::uniformRadius, [](double r) { return r; }), kLattice);
    EXPECT_LT(gapOf(AimShape::rootRadius, [](double r) { return r * r; }), kLattice);
    EXPECT_LT(gapOf(AimShape::polarHelper, [](double r) { return r; }), kLattice);
    // Of a ball of density 1 / sqrt(1 - r^2).
    EXPECT_LT(gapOf(AimShape::flatDisc,
                    [](double r) {
                        return (std::asin(r) - r * std::sqrt(1.0 - r * r)) * 2.0 / std::numbers::pi;
                    }),
              kLattice);
    for (int i = 0; i < 4096; i += 64)
        EXPECT_NEAR(aimOf(AimShape::surface, i).magnitude(), 1.0, 1e-9);
}

}  // namespace
}  // namespace ticker::tasks
