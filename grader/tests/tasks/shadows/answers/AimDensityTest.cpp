#include <grader/tasks/shadows/answers/AimDensity.h>
#include <grader/tasks/support/Draw.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ticker::tasks {
namespace {

const std::vector<Vector3> kOneWay{{0.0, 0.0, 1.0}};

/// Whether the feet of 2000 aims lie between those of the accepted shapes. The aims have random
/// directions, and `size` times a power of an evenly drawn number as their radius: a power of 1/3
/// fills a ball.
/// @param widest  The largest distance of a foot that the verdict contains.
bool isBetween(double power, double size = 1.0, double widest = 0.999) {
    Draw draw{5, 7};
    const Perpendiculars sides = perpendicularsOf(kOneWay[0]);
    Views seen;
    seen.each.resize(1);
    for (int i = 0; i < 2000; ++i) {
        const double radius = size * std::pow(draw.between(0.0, 1.0), power);
        const Vector3 aim = draw.direction() * radius;
        seen.each[0].add(aim - kOneWay[0] * aim.dot(kOneWay[0]), sides);
    }
    seen.finish();
    AimVerdict verdict;
    verdict.distinct = 2000;
    verdict.widest = widest;
    return liesBetween(seen, kOneWay, verdict);
}

// From radii drawn evenly (a power of 1) to the surface (0).
TEST(LiesBetween, AcceptsRadiiFromEvenlyDrawnOnesToThoseOfTheSurface) {
    for (const double power : {0.0, 0.2, 1.0 / 3.0, 0.7, 1.0})
        EXPECT_TRUE(isBetween(power)) << power;
    EXPECT_FALSE(isBetween(2.0)) << "denser in the middle";
    EXPECT_FALSE(isBetween(0.0, 1.2)) << "denser at the rim";
}

// Of 2000 lines of the shape with the fewest there, one passes outside of 0.96 but for a chance of
// 4e-7.
TEST(LiesBetween, WantsALineNearTheRim) {
    const double missed = 1.0 - std::pow(4e-7, 1.0 / 2000.0);
    const double rim = std::sqrt(1.0 - std::pow(3.0 * missed, 2.0 / 3.0));
    EXPECT_TRUE(isBetween(0.5, 1.0, rim + 1e-3));
    EXPECT_FALSE(isBetween(0.5, 1.0, rim - 1e-3));
}

}  // namespace
}  // namespace ticker::tasks
