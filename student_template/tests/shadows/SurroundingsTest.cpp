// Objects that cast no shadow on a point: an object behind the light, another light, the surface.
#include <questions/RayGeometry.h>
#include <shadows/Room.h>
#include <shadows/SoftShadows.h>
#include <support/Complaint.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace raytracer::tests::shadows {
namespace {

TEST_F(SoftShadows, NothingBehindTheLightCastsAShadow) {
    SceneDescription scene = emptyRoom();
    const Vector3 point = floorAt(1.5);
    const Vector3 onwards = (kLight - point).normalised();
    scene.spheres.push_back({kLight + onwards * 2.5, 1.5, floorMaterial(), nullptr});
    const Trial trial{scene, point, 200};
    const ColourRGB expected = ambientOnly() + unshadowed(scene, 0, point).sum();
    if (isNear(trial.mean(), expected, 0.04)) return;
    complain("a point of the floor; a ball stands behind the light as seen from there",
             words(expected) + ", all of the light", words(trial.mean()) + " on average",
             "a hit counts only where it is nearer than the point on the light: compare the hit's "
             "distance with the length of the way there (directions of unit length!)",
             "Soft shadows (T2.1), step 1");
}

TEST_F(SoftShadows, EachLightIsCountedByItself) {
    SceneDescription scene = roomWithBall();
    scene.pointLights.emplace_back(Vector3{-6.0, 3.0, 5.0}, ColourRGB{0.5, 0.6, 0.9}, 300.0);
    const Vector3 point = floorAt(0.2);
    const ColourRGB expected = ambientOnly() + unshadowed(scene, 1, point).sum();
    const Trial first{scene, point, 200};
    std::swap(scene.pointLights[0], scene.pointLights[1]);
    const Trial second{scene, point, 200};
    for (const ColourRGB& mean : {first.mean(), second.mean()}) {
        if (isNear(mean, expected, 0.04)) continue;
        complain("a point that the ball hides from one of two lights",
                 words(expected) + ", the ambient light and all of the other light",
                 words(mean) + " on average",
                 "the count of rays that arrive starts anew for each light, and ambient light is "
                 "added once",
                 "Soft shadows (T2.1), steps 2 and 3");
        return;
    }
}

ColourRGB litBall(const SceneDescription& scene, const Vector3& normal, const Vector3& point) {
    const Vector3 path = kLight - point;
    return ambientOnly() + questions::phongTerms(floorMaterial(), scene.pointLights[0], normal,
                                                 (kEye - point).normalised(), path.normalised(),
                                                 path.magnitude())
                               .sum();
}

TEST_F(SoftShadows, NoSurfaceCastsAShadowOnItself) {
    const SceneDescription scene = roomWithBall();
    // Half-way between the directions to the light and to the eye: the points face both.
    const Vector3 towards =
        ((kLight - kBall).normalised() + (kEye - kBall).normalised()).normalised();
    ColourRGB got;
    ColourRGB expected;
    // Rounding puts some points a little inside the ball, others outside.
    constexpr int kPoints = 100;
    for (int i = 0; i < kPoints; ++i) {
        const Vector3 aside{0.15 * std::cos(i), 0.1 * std::sin(i), 0.0};
        const Vector3 normal = (towards + aside).normalised();
        const Vector3 point = kBall + normal * kBallRadius;
        got += Trial{scene, point, 1, 0}.mean() / kPoints;
        expected += litBall(scene, normal, point) / kPoints;
    }
    if (isNear(got, expected, 0.05)) return;
    complain("points of the ball that look at the light and at the eye",
             words(expected) + ", all of the light", words(got) + " on average",
             "the shadow ray must start a little above the surface: P + N * kShadowBias",
             "Soft shadows (T2.1), step 1");
}

}  // namespace
}  // namespace raytracer::tests::shadows
