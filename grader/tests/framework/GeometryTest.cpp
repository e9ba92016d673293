#include <raytracer/base/Error.h>
#include <raytracer/geometry/HeightMap.h>
#include <raytracer/geometry/Plane.h>
#include <raytracer/geometry/Sphere.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace raytracer {
namespace {

constexpr double kGeometryRounding = 1e-12;

const Sphere kSphere{{0, 0, 5}, 2.0, {}};
const Plane kFloor{{0, -1, 0}, {0, 3, 0}, {}};

TEST(SphereIntersection, IsTheNearSideSeenFromOutside) {
    const std::optional<RaycastHit> hit = kSphere.intersectionWith({{0, 0, 0}, {0, 0, 1}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->object, &kSphere);
    EXPECT_NEAR(hit->distance, 3.0, kGeometryRounding);
    EXPECT_NEAR((hit->location - Vector3{0, 0, 3}).magnitude(), 0.0, kGeometryRounding);
    EXPECT_NEAR((hit->normal - Vector3{0, 0, -1}).magnitude(), 0.0, kGeometryRounding);
}

TEST(SphereIntersection, IsTheFarSideSeenFromInside) {
    const std::optional<RaycastHit> hit = kSphere.intersectionWith({{0, 1, 5}, {0, 1, 0}});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 1.0, kGeometryRounding);
    EXPECT_NEAR((hit->normal - Vector3{0, 1, 0}).magnitude(), 0.0,
                kGeometryRounding);  // still outwards
}

TEST(SphereIntersection, CountsInLengthsOfTheDirection) {
    for (const double length : {1e-6, 0.25, 1.0, 3.0, 1e6}) {
        const std::optional<RaycastHit> hit = kSphere.intersectionWith({{}, {0, 0, length}});
        ASSERT_TRUE(hit) << length;
        EXPECT_NEAR(hit->distance * length, 3.0, kGeometryRounding) << length;
        EXPECT_NEAR(hit->location.z, 3.0, kGeometryRounding) << length;
    }
}

TEST(SphereIntersection, IsNoneBehindTheOriginOrPastTheSphere) {
    EXPECT_FALSE(kSphere.intersectionWith({{0, 0, 8}, {0, 0, 1}}));
    EXPECT_FALSE(kSphere.intersectionWith({{0, 2.1, 0}, {0, 0, 1}}));
    EXPECT_FALSE(kSphere.intersectionWith({{0, 0, 0}, {0, 1, 0}}));
}

TEST(SphereIntersection, ExistsForARayThatGrazes) {
    // Just inside and just outside the rim; squares lose half of a double's digits there.
    EXPECT_TRUE(kSphere.intersectionWith({{0, 2.0 - 1e-7, 0}, {0, 0, 1}}));
    EXPECT_FALSE(kSphere.intersectionWith({{0, 2.0 + 1e-7, 0}, {0, 0, 1}}));
    const std::optional<RaycastHit> hit = kSphere.intersectionWith({{0, 2, 0}, {0, 0, 1}});
    ASSERT_TRUE(hit);  // all terms are exact here
    EXPECT_NEAR(hit->distance, 5.0, kGeometryRounding);
}

TEST(SphereIntersection, DoesNotFindTheSurfaceThatARayLeaves) {
    const Vector3 surface{0, 0, 3};
    EXPECT_FALSE(kSphere.intersectionWith({surface + Vector3{0, 0, -1e-4}, {0.6, 0, -0.8}}));
}

TEST(PlaneIntersection, IsFoundFromBothSidesWithTheNormalUnturned) {
    const std::optional<RaycastHit> above = kFloor.intersectionWith({{0, 1, 0}, {0, -0.5, 0.5}});
    ASSERT_TRUE(above);
    EXPECT_NEAR(above->distance, 4.0, kGeometryRounding);
    EXPECT_NEAR((above->location - Vector3{0, -1, 2}).magnitude(), 0.0, kGeometryRounding);
    EXPECT_EQ(above->normal, Vector3(0, 1, 0));  // of unit length
    const std::optional<RaycastHit> below = kFloor.intersectionWith({{0, -3, 0}, {0, 1, 0}});
    ASSERT_TRUE(below);
    EXPECT_NEAR(below->distance, 2.0, kGeometryRounding);
    EXPECT_EQ(below->normal, Vector3(0, 1, 0));
}

TEST(PlaneIntersection, IsNoneBehindOrAlongThePlane) {
    EXPECT_FALSE(kFloor.intersectionWith({{0, 1, 0}, {0, 1, 0}}));
    EXPECT_FALSE(kFloor.intersectionWith({{0, 1, 0}, {1, 0, 0}}));
    EXPECT_FALSE(kFloor.intersectionWith({{0, -1, 0}, {1, 0, 0}}));  // inside the plane
}

TEST(HeightMapAt, NamesTheTexelThatIsOutside) {
    const HeightMap map = HeightMap::fromBytes(4, 5, std::vector<std::uint8_t>(20, 255));
    EXPECT_EQ(map.at(3, 4), kBumpFactor);
    for (const auto& [column, row] : {std::pair{4, 0}, {-1, 2}, {0, 5}, {3, -7}}) {
        try {
            static_cast<void>(map.at(column, row));
            ADD_FAILURE() << column << ", " << row;
        } catch (const Error& error) {
            const std::string message = error.what();
            EXPECT_NE(message.find("column " + std::to_string(column)), std::string::npos);
            EXPECT_NE(message.find("row " + std::to_string(row)), std::string::npos);
            EXPECT_NE(message.find("4 x 5"), std::string::npos);
        }
    }
}

TEST(HeightMap, RefusesSidesBelowFourAndWrongCounts) {
    EXPECT_THROW(HeightMap(3, 4, std::vector<double>(12)), Error);
    EXPECT_THROW(HeightMap(4, 3, std::vector<double>(12)), Error);
    EXPECT_THROW(HeightMap(4, 4, std::vector<double>(15)), Error);
}

TEST(Vector3, ReflectsAVectorThatPointsAway) {
    EXPECT_EQ(Vector3(1, 1, 0).reflectIn({0, 1, 0}), Vector3(-1, 1, 0));
    EXPECT_EQ(Vector3(0, 2, 0).reflectIn({0, 1, 0}), Vector3(0, 2, 0));
}

TEST(Vector3, CrossesAsTheFormulaSays) {
    EXPECT_EQ(Vector3(1, 0, 0).cross({0, 1, 0}), Vector3(0, 0, 1));
    EXPECT_EQ(Vector3(1, 2, 3).cross({4, 5, 6}), Vector3(-3, 6, -3));
}

}  // namespace
}  // namespace raytracer
