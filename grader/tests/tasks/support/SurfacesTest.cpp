#include <grader/tasks/support/Distinct.h>
#include <grader/tasks/support/Surfaces.h>

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

namespace ticker::tasks {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
const Vector3 kRight{1.0, 0.0, 0.0};

/// A ball of radius 1 around (5, 0, 0) and a wall at x = 9 whose normal is not of unit length.
raytracer::SceneDescription ballAndWall() {
    raytracer::SceneDescription scene;
    scene.spheres.push_back({{5.0, 0.0, 0.0}, 1.0, {}, nullptr});
    scene.planes.push_back({{9.0, 3.0, 0.0}, {-2.0, 0.0, 0.0}, {}});
    scene.planes.back().material.phongKD = 0.25;
    return scene;
}

Sight sight(const Vector3& origin, const Vector3& direction, double reach) {
    return Surfaces{ballAndWall()}.sightAlong(origin, direction, reach);
}

TEST(SightAlong, EndsAtTheFirstSurfaceBeforeItsReach) {
    EXPECT_EQ(sight({}, kRight, 3.99), Sight::open);
    EXPECT_EQ(sight({}, kRight, 4.01), Sight::blocked);
    EXPECT_EQ(sight({0.0, 1.5, 0.0}, kRight, 8.99), Sight::open) << "past the ball";
    EXPECT_EQ(sight({0.0, 1.5, 0.0}, kRight, 9.01), Sight::blocked) << "to the wall";
    EXPECT_EQ(sight({0.0, 1.5, 0.0}, -kRight, kEndless), Sight::open) << "away from the wall";
    EXPECT_EQ(sight({0.0, 0.0, 0.0}, -kRight, kEndless), Sight::open) << "away from the ball";
    EXPECT_EQ(sight({0.0, 1.5, 0.0}, {0.0, 1.0, 0.0}, kEndless), Sight::open) << "along the wall";
}

TEST(SightAlong, SeesTheFarSideFromWithin) {
    EXPECT_EQ(sight({5.2, 0.0, 0.0}, kRight, 0.79), Sight::open);
    EXPECT_EQ(sight({5.2, 0.0, 0.0}, kRight, 0.81), Sight::blocked);
}

TEST(SightAlong, IsNotStoppedByTheSurfaceThatItLeaves) {
    EXPECT_EQ(sight({3.9999, 0.0, 0.0}, -kRight, kEndless), Sight::open);
    EXPECT_EQ(sight({6.0001, 0.0, 0.0}, kRight, 2.9), Sight::open);
    EXPECT_EQ(sight({8.9999, 0.0, 0.0}, -kRight, 2.9), Sight::open);
    EXPECT_EQ(sight({8.9999, 0.0, 0.0}, -kRight, 3.1), Sight::blocked);
    EXPECT_EQ(sight({8.9999, 0.0, 0.0}, kRight, kEndless), Sight::blocked) << "into the wall";
    EXPECT_EQ(sight({9.0, 0.0, 0.0}, -kRight, 2.0), Sight::unsure) << "starts on it";
    EXPECT_EQ(sight({4.0, 0.0, 0.0}, -kRight, 2.0), Sight::unsure);
}

// Within 2e-6 of the ball's radius, on either side.
TEST(SightAlong, IsUnsureWhereRoundingDecides) {
    EXPECT_EQ(sight({0.0, 1.0 - 1e-6, 0.0}, kRight, 8.0), Sight::unsure) << "grazes from within";
    EXPECT_EQ(sight({0.0, 1.0 + 1e-6, 0.0}, kRight, 8.0), Sight::unsure) << "grazes from outside";
    EXPECT_EQ(sight({0.0, 1.0 - 1e-5, 0.0}, kRight, 8.0), Sight::blocked);
    EXPECT_EQ(sight({0.0, 1.0 + 1e-5, 0.0}, kRight, 8.0), Sight::open);
    EXPECT_EQ(sight({}, kRight, 4.0 + 1e-6), Sight::unsure) << "ends before or behind it";
    EXPECT_EQ(sight({}, kRight, 4.0 - 1e-6), Sight::unsure);
}

TEST(HitsAlong, ServeEveryReachOfOneRay) {
    const NearestHits hits = Surfaces{ballAndWall()}.hitsAlong({}, kRight);
    EXPECT_EQ(hits.plain, 4.0);
    EXPECT_NEAR(hits.small - hits.plain, 2e-6, 1e-12);
    EXPECT_NEAR(hits.plain - hits.large, 2e-6, 1e-12);
    EXPECT_EQ(hits.sightUpTo(3.9), Sight::open);
    EXPECT_EQ(hits.sightUpTo(4.1), Sight::blocked);
    EXPECT_EQ(hits.sightUpTo(4.0), Sight::unsure);
}

TEST(NumberOfDifferent, CountsEqualValuesOnce) {
    using Pairs = std::vector<std::array<int, 2>>;
    EXPECT_EQ(numberOfDifferent(Pairs{}), 0U);
    EXPECT_EQ(numberOfDifferent(Pairs{{1, 2}, {2, 1}, {1, 2}, {1, 3}}), 3U);
}

TEST(DistanceToNearest, IsThatOfBallsFromBothSidesAndOfPlanes) {
    const Surfaces surfaces{ballAndWall()};
    EXPECT_NEAR(surfaces.distanceToNearest({2.0, 0.0, 0.0}), 2.0, 1e-12);
    EXPECT_NEAR(surfaces.distanceToNearest({5.3, 0.0, 0.0}), 0.7, 1e-12);
    EXPECT_NEAR(surfaces.distanceToNearest({8.5, 7.0, 0.0}), 0.5, 1e-12);
    EXPECT_NEAR(surfaces.distanceToNearest({9.25, 0.0, 0.0}), 0.25, 1e-12);
}

TEST(MaterialOf, CountsSpheresFirst) {
    const raytracer::SceneDescription scene = ballAndWall();
    EXPECT_EQ(materialOf(scene, 0).phongKD, 0.8);
    EXPECT_EQ(materialOf(scene, 1).phongKD, 0.25);
}

}  // namespace
}  // namespace ticker::tasks
