#include <grader/oracle/Oracle.h>
#include <grader/tests/oracle/TestScenes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ticker::oracle::test {
namespace {

using raytracer::RenderSettings;
using raytracer::SceneDescription;
using raytracer::Vector3;

// Means in single precision, a few hundred paths.
constexpr double kFloatError = 1e-5;

constexpr double kAmbient = 0.1;

/// One pixel that looks straight ahead, with a tiny lens.
RenderSettings onePixel() {
    RenderSettings settings;
    settings.width = settings.height = 1;
    settings.bounces = 0;
    settings.dofAmount = 1e-6;
    return settings;
}

/// A matt white wall at z = 5 that faces the camera and is lit by one light in front of it.
SceneDescription wallScene(const Vector3& light, double intensity) {
    SceneDescription scene;
    scene.ambientLighting = raytracer::ColourRGB{kAmbient};
    scene.pointLights.emplace_back(light, raytracer::ColourRGB{1.0}, intensity);
    scene.planes = {plane({0.0, 0.0, 5.0}, {0.0, 0.0, -1.0}, 0xffffff)};
    scene.planes[0].material.phongKS = 0.0;
    return scene;
}

Moments momentsWith(const SceneDescription& scene, const RenderSettings& settings, bool closedForms,
                    int paths) {
    Tricks tricks;
    tricks.closedForms = closedForms;
    Precision precision;
    precision.minLensPaths = precision.maxLensPaths = paths;
    return Oracle{scene, settings, {}, {}, tricks}.moments(5, precision);
}

// Light at the wall's centre without shadow: kD I / (4 pi d^2) cos.
double diffuseAtWall(const Vector3& light, double intensity) {
    const Vector3 apart = light - Vector3{0.0, 0.0, 5.0};
    const double distance2 = apart.dot(apart);
    return 0.8 * intensity / (4.0 * std::numbers::pi * distance2) * -apart.z / std::sqrt(distance2);
}

TEST(OracleAnalytic, UnoccludedLightIsPhongsFormulaWithoutNoise) {
    const Vector3 light{1.0, 2.0, 1.0};
    const Moments moments = momentsWith(wallScene(light, 200.0), onePixel(), true, 64);
    EXPECT_NEAR(moments.mean[0].g, kAmbient + diffuseAtWall(light, 200.0), kFloatError);
    EXPECT_NEAR(moments.covariance[0].gg, 0.0, 1e-10);
}

TEST(OracleAnalytic, FullShadowLeavesTheAmbientLight) {
    SceneDescription scene = wallScene({0.5, 0.5, 1.0}, 200.0);
    scene.spheres = {sphere({0.3, 0.3, 2.6}, 0.35, 0xffffff)};
    for (const bool closed : {true, false}) {
        const Moments moments = momentsWith(scene, onePixel(), closed, 64);
        EXPECT_NEAR(moments.mean[0].g, kAmbient, kFloatError);
        EXPECT_NEAR(moments.covariance[0].gg, 0.0, 1e-10);
    }
}

// A plane through the light hides a cap of its ball: the share that is seen is
// (1 + s)^2 (2 - s) / 4, with s the distance of the ball's centre from the plane in radii, positive
// on the side of the point.
TEST(OracleAnalytic, PlaneThroughTheLightHidesACapOfIt) {
    const Vector3 light{0.0, 2.0, 3.0};
    for (const double height : {-0.3, -0.1, 0.0, 0.15, 0.35}) {
        SceneDescription scene = wallScene(light, 200.0);
        scene.planes.push_back(plane({0.0, 2.0 - height, 0.0}, {0.0, 1.0, 0.0}, 0));
        // The point on the wall is below the plane: it sees what is below it.
        const double s = -height / 0.4;
        const double share = 0.25 * (1.0 + s) * (1.0 + s) * (2.0 - s);
        const double full = diffuseAtWall(light, 200.0);
        const Moments exact = momentsWith(scene, onePixel(), true, 64);
        EXPECT_NEAR(exact.mean[0].g, kAmbient + full * share, kFloatError);
        // 10 shadow rays for each of 50 lens paths.
        EXPECT_NEAR(exact.covariance[0].gg, full * full * share * (1.0 - share) / 500.0, 1e-7);
        // 65536 paths with two rays: even random points would be 0.0014 off at most (1 sigma);
        // 5 sigma, false alarm below 1e-6.
        const Moments sampled = momentsWith(scene, onePixel(), false, 1 << 16);
        EXPECT_NEAR(sampled.mean[0].g, kAmbient + full * share, 0.0014 * 5.0 * full);
        EXPECT_NEAR(sampled.covariance[0].gg, full * full * share * (1.0 - share) / 500.0,
                    0.01 * full * full / 500.0);
    }
}

// The share of a small and distant ball of light that a half-plane hides whose edge is s radii off
// the ball's centre.
double hiddenByHalfPlane(double s) {
    return 0.25 * (2.0 + s) * (1.0 - s) * (1.0 - s);
}

constexpr double kOccluderRadius = 20.0;
constexpr double kOccluderDistance = 22.0;

// A black sphere whose rim, seen from a point that looks along -z, stands at this angle from the
// axis; it covers the side of the axis with positive x.
raytracer::SphereDescription sphereWithRimAt(const Vector3& point, double angle) {
    const double halfWidth = std::asin(kOccluderRadius / kOccluderDistance);
    const double centre = halfWidth + angle;
    const Vector3 direction{std::sin(centre), 0.0, -std::cos(centre)};
    return sphere(point + direction * kOccluderDistance, kOccluderRadius, 0);
}

// A sphere so large that its rim is straight across a small and distant light has the penumbra of a
// half-plane. The ball's perspective and the rim's bend are below 1 % of it (light's half-angle
// 0.008, rim's radius 2500 times the penumbra's).
TEST(OracleAnalytic, StraightEdgeCastsTheHalfPlanesPenumbra) {
    const Vector3 point{0.0, 0.0, 5.0};
    constexpr double kLightDistance = 50.0;
    constexpr double kIntensity = 2e4;
    constexpr double kPenumbraError = 0.01;
    constexpr int kPaths = 64;
    const Vector3 light = point - Vector3{0.0, 0.0, kLightDistance};
    RenderSettings settings = onePixel();
    settings.dofFocalPlane = point.z;
    // The lens is moved to a place from which the sphere does not hide the wall.
    constexpr double kLensX = -9.0;
    Mistake mistake;
    mistake.lensOffsetX = kLensX / settings.dofAmount;
    Precision precision;
    precision.minLensPaths = precision.maxLensPaths = kPaths;
    const double full = diffuseAtWall(light, kIntensity);
    for (const double s : {-0.8, -0.3, 0.0, 0.4, 0.9}) {
        SceneDescription scene = wallScene(light, kIntensity);
        scene.spheres = {sphereWithRimAt(point, s * settings.lightSize / kLightDistance)};
        const Moments moments = Oracle{scene, settings, {}, mistake}.moments(5, precision);
        const double lit = (moments.mean[0].g - kAmbient) / full;
        EXPECT_NEAR(lit, 1.0 - hiddenByHalfPlane(s), kPenumbraError) << "s = " << s;
    }
}

TEST(OracleAnalytic, WhatLiesOnTheFocalPlaneIsSharp) {
    RenderSettings settings = onePixel();
    settings.dofAmount = 0.3;
    settings.dofFocalPlane = 5.0;
    const Vector3 light{0.7, 1.5, 1.0};
    const Moments moments = momentsWith(wallScene(light, 200.0), settings, true, 256);
    EXPECT_NEAR(moments.mean[0].g, kAmbient + diffuseAtWall(light, 200.0), kFloatError);
    EXPECT_NEAR(moments.covariance[0].gg, 0.0, 1e-9);
    settings.dofFocalPlane = 4.0;
    const Moments blurred = momentsWith(wallScene(light, 200.0), settings, true, 256);
    EXPECT_GT(blurred.covariance[0].gg, 1e-7);
}

// Inside a white ball with ambient light 1 and no lamp, every mirror shows 1.
TEST(OracleAnalytic, FurnaceIsConstant) {
    SceneDescription scene;
    scene.spheres = {sphere({0.0, 0.0, 0.0}, 10.0, 0xffffff),
                     sphere({0.2, 0.1, 4.0}, 0.8, 0xffffff)};
    // The outer ball is no mirror: a ray mirrored inside of a ball would start outside, moved along
    // the normal by the bias.
    scene.spheres[0].material.reflectivity = 0.0;
    RenderSettings settings;
    settings.width = 16;
    settings.height = 12;
    const Moments moments = momentsWith(scene, settings, true, 128);
    for (std::size_t i = 0; i < moments.mean.size(); ++i) {
        EXPECT_NEAR(moments.mean[i].r, 1.0, kFloatError);
        EXPECT_NEAR(moments.covariance[i].rr, 0.0, 1e-9);
    }
}

TEST(OracleAnalytic, RaysThatHitNothingGiveTheBackground) {
    const Moments moments = momentsWith(SceneDescription{}, onePixel(), true, 64);
    EXPECT_NEAR(moments.mean[0].b, 0.001, 1e-8);
}

}  // namespace
}  // namespace ticker::oracle::test
