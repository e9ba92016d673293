#include <grader/tests/tasks/maintick/AltersHits.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ticker::tasks {
namespace {

// Single precision must be right at these distances; see JudgePlanes.cpp and JudgeSpheres.cpp.
TEST(JudgeHits, AsksFartherAwayThan1500UnitsAndNearerThan4100) {
    const auto farthestOf = [](auto judge) {
        double farthest = 0.0;
        static_cast<void>(judge([&](probe::Hit& hit, const Asked&, const probe::CastRay& ray) {
            farthest = std::max({farthest, ray.origin.magnitude(), hit.distance});
        }));
        return farthest;
    };
    for (const double farthest : {farthestOf(ofSpheres), farthestOf(ofPlanes)}) {
        EXPECT_GT(farthest, 1500.0);
        EXPECT_LT(farthest, 4100.0);
    }
}

// Mirrored rays and shadow rays meet objects behind the camera, too.
TEST(JudgeHits, AsksOnBothSidesOfTheCameraUnderEverySeed) {
    const Change dropped = [](probe::Hit& hit, const Asked&, const probe::CastRay&) {
        if (hit.location.z < 0.0) hit.isHit = false;
    };
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        AltersHits examinee{dropped};
        expectOne(judgeSpheres(examinee, seed).findings, "sphere.missed", "behind the camera");
        expectOne(judgePlanes(examinee, seed).findings, "plane.missed", "behind the camera");
    }
}

// Code may take such rays for parallel ones, and a division by a coordinate of the direction fails
// only for them.
TEST(JudgeHits, AsksLevelRaysAndThoseAlongAnAxisUnderEverySeed) {
    const auto stillMisses = [](bool x, bool y, bool z) -> Change {
        return [=](probe::Hit& hit, const Asked&, const probe::CastRay& ray) {
            const Vector3& D = ray.direction;
            if ((!x || D.x == 0.0) && (!y || D.y == 0.0) && (!z || D.z == 0.0)) hit.isHit = false;
        };
    };
    for (std::uint64_t seed = 1; seed <= 30; ++seed)
        for (const Change& change :
             {stillMisses(true, false, false), stillMisses(false, true, false),
              stillMisses(false, false, true), stillMisses(true, true, false),
              stillMisses(true, false, true), stillMisses(false, true, true)}) {
            AltersHits examinee{change};
            expectOne(judgeSpheres(examinee, seed).findings, "sphere.missed", "has a 0 among");
            expectOne(judgePlanes(examinee, seed).findings, "plane.missed", "has a 0 among");
        }
}

// Such rays show a floor's horizon in a picture. A tolerance as small as the height of a row of
// pixels is right.
TEST(JudgeHits, AsksNearlyParallelRaysUnderEverySeed) {
    const auto parallelBelow = [](double limit) {
        return [=](probe::Hit& hit, const Asked& asked, const probe::CastRay& ray) {
            const auto& plane = asked.scene.planes[static_cast<std::size_t>(ray.object)];
            const double slope = ray.direction.normalised().dot(plane.normal.normalised());
            if (std::abs(slope) < limit) hit.isHit = false;
        };
    };
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        AltersHits limited{parallelBelow(0.004)};
        expectOne(judgePlanes(limited, seed).findings, "plane.missed", "tolerance of D.N");
        AltersHits right{parallelBelow(0.001)};
        EXPECT_TRUE(judgePlanes(right, seed).findings.empty()) << seed;
    }
}

// The near root of a ray that starts inside is a little below 0.
TEST(JudgeHits, AsksInsideNearTheSurfaceUnderEverySeed) {
    const auto behindCounts = [](bool isHit) {
        return [=](probe::Hit& hit, const Asked& asked, const probe::CastRay& ray) {
            const auto& sphere = asked.scene.spheres[static_cast<std::size_t>(ray.object)];
            const raytracer::Ray backwards{ray.origin, -ray.direction};
            const auto back = meet(sphere, backwards);
            if (!hit.isHit || !back || back->distance > 0.05) return;
            hit.isHit = isHit;
            hit.distance = -back->distance;
        };
    };
    for (std::uint64_t seed = 1; seed <= 60; ++seed)
        for (const bool isHit : {false, true}) {
            AltersHits examinee{behindCounts(isHit)};
            expectOne(judgeSpheres(examinee, seed).findings, "sphere.inside", "limit below 0");
        }
}

// The far root of a ray that starts just past a sphere is a little below 0.
TEST(JudgeHits, AsksJustPastTheFarSideUnderEverySeed) {
    const Change behindCounts = [](probe::Hit& hit, const Asked& asked, const probe::CastRay& ray) {
        const auto& sphere = asked.scene.spheres[static_cast<std::size_t>(ray.object)];
        const Vector3 fromCentre = ray.origin - sphere.centre;
        const auto back = meet(sphere, {ray.origin, -ray.direction});
        if (fromCentre.magnitude() < sphere.radius || !back || back->distance > 0.05) return;
        hit.isHit = true;
        hit.distance = -back->distance;
    };
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        AltersHits examinee{behindCounts};
        expectOne(judgeSpheres(examinee, seed).findings, "sphere.behind", "limit below 0");
    }
}

// A lower limit of the distance shows only there. Small limits are right readings.
TEST(JudgeHits, AsksTwoThousandthsAwayUnderEverySeed) {
    const auto from = [](double limit) {
        return [=](probe::Hit& hit, const Asked&, const probe::CastRay&) {
            if (hit.distance < limit) hit.isHit = false;
        };
    };
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        AltersHits limited{from(0.003)};
        expectOne(judgeSpheres(limited, seed).findings, "sphere.missed", "near hits");
        expectOne(judgePlanes(limited, seed).findings, "plane.missed", "near hits");
        AltersHits right{from(0.0015)};
        EXPECT_TRUE(judgeSpheres(right, seed).findings.empty()) << seed;
        EXPECT_TRUE(judgePlanes(right, seed).findings.empty()) << seed;
    }
}

// A limit that grows with the radius shows only at a large sphere. Rays start on either side of its
// surface.
TEST(JudgeHits, AsksNearTheSurfaceOfALargeSphereUnderEverySeed) {
    constexpr double kShare = 5e-4;  // 0.1 of the large one, 0.0012 of the others
    const auto radiusOf = [](const Asked& asked, const probe::CastRay& ray) {
        return asked.scene.spheres[static_cast<std::size_t>(ray.object)].radius;
    };
    const Change lost = [=](probe::Hit& hit, const Asked& asked, const probe::CastRay& ray) {
        if (hit.distance < kShare * radiusOf(asked, ray)) hit.isHit = false;
    };
    const auto behindCounts = [=](bool isInside) {
        return [=](probe::Hit& hit, const Asked& asked, const probe::CastRay& ray) {
            const auto& sphere = asked.scene.spheres[static_cast<std::size_t>(ray.object)];
            const auto back = meet(sphere, {ray.origin, -ray.direction});
            const bool isThere = (ray.origin - sphere.centre).magnitude() < sphere.radius;
            if (isThere != isInside || !back || back->distance > kShare * sphere.radius) return;
            hit.isHit = true;
            hit.distance = -back->distance;
        };
    };
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        AltersHits near{lost};
        expectOne(judgeSpheres(near, seed).findings, "sphere.missed", "however large the sphere");
        AltersHits inside{behindCounts(true)};
        expectOne(judgeSpheres(inside, seed).findings, "sphere.inside", "however large the sphere");
        AltersHits behind{behindCounts(false)};
        expectOne(judgeSpheres(behind, seed).findings, "sphere.behind", "limit below 0");
    }
}

// The discriminant is 4 (r^2 - d^2): of a small sphere it is small even through the middle.
TEST(JudgeHits, AsksThroughTheMiddleOfASmallSphereUnderEverySeed) {
    const auto upTo = [](double tolerance) {
        return [=](probe::Hit& hit, const Asked& asked, const probe::CastRay& ray) {
            const auto& sphere = asked.scene.spheres[static_cast<std::size_t>(ray.object)];
            const double away =
                (sphere.centre - ray.origin).cross(ray.direction.normalised()).magnitude();
            const double square = sphere.radius * sphere.radius - away * away;
            if (4.0 * square < tolerance) hit.isHit = false;
        };
    };
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        for (const double tolerance : {6e-4, 1e-3, 1e-2}) {
            AltersHits limited{upTo(tolerance)};
            expectOne(judgeSpheres(limited, seed).findings, "sphere.missed", "tolerance");
        }
        AltersHits right{upTo(1e-4)};
        EXPECT_TRUE(judgeSpheres(right, seed).findings.empty()) << seed;
    }
}

// Simulates code with a formula of its own for floors and walls. The formula is right only where
// the normal lies along an axis.
TEST(JudgeHits, AsksOfPlanesThatLeanFromEachAxisUnderEverySeed) {
    constexpr double kAlmost = 0.999;
    for (const auto coordinate : {&Vector3::x, &Vector3::y, &Vector3::z})
        for (const double sign : {-1.0, 1.0}) {
            AltersHits examinee{[=](probe::Hit& hit, const Asked& asked,
                                    const probe::CastRay& ray) {
                const auto& planes = asked.scene.planes;
                const auto& plane = planes[static_cast<std::size_t>(ray.object)];
                if (plane.normal.normalised().*coordinate * sign < kAlmost || isLong(ray)) return;
                hit.distance =
                    (plane.point.*coordinate - ray.origin.*coordinate) / ray.direction.*coordinate;
                hit.isHit = hit.distance > 0.0;
            }};
            for (std::uint64_t seed = 1; seed <= 60; ++seed)
                expectOne(judgePlanes(examinee, seed).findings, "plane.distance",
                          "One coordinate alone");
        }
}

}  // namespace
}  // namespace ticker::tasks
