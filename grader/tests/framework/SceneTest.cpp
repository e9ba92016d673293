#include "RecordingObserver.h"

#include <raytracer/math/Random.h>
#include <raytracer/scene/Scene.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace raytracer {
namespace {

Vector3 randomVector(double half) {
    const double x = randomBetween(-half, half);
    const double y = randomBetween(-half, half);
    return {x, y, randomBetween(-half, half)};
}

SceneDescription randomScene(int spheres, int planes) {
    const auto map = std::make_shared<const HeightMap>(4, 4, std::vector<double>(16, 1.0));
    SceneDescription scene;
    for (int i = 0; i < spheres; ++i)
        scene.spheres.push_back(
            {randomVector(4.0), randomBetween(0.1, 1.5), {}, i % 5 == 4 ? map : nullptr});
    for (int i = 0; i < planes; ++i)
        scene.planes.push_back({randomVector(4.0), randomVector(1.0), {}});
    return scene;
}

/// The definition of findClosestIntersection: ask every object, keep the nearest.
std::optional<RaycastHit> askEveryObject(const Scene& scene, const Ray& ray) {
    std::optional<RaycastHit> nearest;
    for (const auto& object : scene.objects()) {
        const std::optional<RaycastHit> hit = object->intersectionWith(ray);
        if (hit && (!nearest || hit->distance < nearest->distance)) nearest = hit;
    }
    return nearest;
}

void expectSameHit(const std::optional<RaycastHit>& hit, const std::optional<RaycastHit>& wanted) {
    ASSERT_EQ(hit.has_value(), wanted.has_value());
    if (!hit) return;
    EXPECT_EQ(hit->object, wanted->object);
    EXPECT_EQ(hit->distance, wanted->distance);
    EXPECT_EQ(hit->location, wanted->location);
    EXPECT_EQ(hit->normal, wanted->normal);
}

TEST(FindClosestIntersection, IsTheNearestHitOfAllObjects) {
    seedRandom(1);
    for (int spheres = 0; spheres <= 9; ++spheres) {
        for (int planes = 0; planes <= 2; ++planes) {
            const Scene scene{randomScene(spheres, planes)};
            for (int i = 0; i < 2000; ++i) {
                // Origins inside spheres and directions of any length are among them.
                const Ray ray{randomVector(5.0), randomVector(std::exp(randomBetween(-9.0, 9.0)))};
                expectSameHit(scene.findClosestIntersection(ray), askEveryObject(scene, ray));
            }
        }
    }
}

TEST(FindClosestIntersection, TakesTheFirstOfTheSceneWhereTwoAreEquallyNear) {
    SceneDescription description;
    for (int i = 0; i < 6; ++i)
        description.spheres.push_back({{0, 0, 5}, 1.0, {}, nullptr});
    description.planes.push_back({{0, 0, 4}, {0, 0, -1}, {}});
    const Scene scene{description};
    const std::optional<RaycastHit> hit = scene.findClosestIntersection({{}, {0, 0, 1}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->object, scene.objects().front().get());
}

TEST(FindClosestIntersection, IsNoneForARayWithoutADirection) {
    seedRandom(2);
    const double no = std::numeric_limits<double>::quiet_NaN();
    const Scene scene{randomScene(6, 2)};
    EXPECT_FALSE(scene.findClosestIntersection({{1, 2, 3}, {}}));
    EXPECT_FALSE(scene.findClosestIntersection({{1, 2, 3}, {no, 0, 1}}));
    EXPECT_FALSE(scene.findClosestIntersection({{1, 2, 3}, {0, 0, -no}}));
    EXPECT_FALSE(scene.findClosestIntersection({{no, no, no}, {0, 0, 1}}));
    EXPECT_FALSE(scene.findClosestIntersection({{1, 2, 3}, {no, no, no}}));
}

TEST(FindClosestIntersection, TellsTheObserverOfEachRay) {
    seedRandom(3);
    ticker::RecordingObserver observer;
    const Scene scene{randomScene(3, 1), &observer};
    std::size_t rays = 0;
    for (double x = -1.0; x <= 1.0; x += 0.25) {
        const Ray ray{{0, 0, -9}, {x, 0.1, 1}};
        const std::optional<RaycastHit> hit = scene.findClosestIntersection(ray);
        ASSERT_EQ(observer.rays.size(), ++rays);
        EXPECT_EQ(observer.rays.back().direction, ray.direction);
        EXPECT_EQ(observer.hits.back().object, hit ? hit->object : nullptr);
        EXPECT_EQ(observer.hits.back().normal, hit ? hit->normal : Vector3{});
    }
}

}  // namespace
}  // namespace raytracer
