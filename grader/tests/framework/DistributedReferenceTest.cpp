#include "RecordingObserver.h"

#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

// Properties of the model answers for T2.1 and T2.2.

namespace raytracer {
namespace {

constexpr double kReferenceRounding = 1e-12;
const Vector3 kPoint{0, 0, 0};
const Vector3 kUp{0, 1, 0};
const Vector3 kViewer{1, 3, -2};

// A floor under one light, and a ball that hides about half of the light from the origin.
SceneDescription penumbraScene(double sideways) {
    SceneDescription scene;
    scene.ambientLighting = ColourRGB{0.02};
    scene.pointLights.push_back({{0, 4, 0}, {1.0, 0.8, 0.6}, 80});
    Material grey;
    grey.colour = ColourRGB{0.5};
    scene.planes.push_back({kPoint, kUp, grey});
    scene.spheres.push_back({{sideways, 2, 0}, 1.0, grey, nullptr});
    return scene;
}

struct Lit {
    ColourRGB colour;
    ticker::RecordingObserver observer;
};

void illuminateOrigin(Lit& lit, const SceneDescription& description, RenderSettings settings = {}) {
    settings.observer = &lit.observer;
    const Scene scene{description, &lit.observer};
    const SceneObject& floor = *scene.objects().back();
    lit.colour = Renderer{settings}.illuminate(scene, floor, kPoint, kUp, kViewer);
}

TEST(ReferenceIlluminate, CastsItsRaysFromJustAboveThePointIntoTheBallOfEachLight) {
    SceneDescription scene = penumbraScene(1.0);
    scene.pointLights.push_back({{-3, 2, 1}, {0.2, 0.4, 0.9}, 30});
    Lit lit;
    illuminateOrigin(lit, scene);
    ASSERT_EQ(lit.observer.rays.size(), 20U);
    for (std::size_t i = 0; i < 20; ++i) {
        const Ray& ray = lit.observer.rays[i];
        EXPECT_EQ(ray.origin, kPoint + kUp * kShadowBias);
        const Vector3 toLight = scene.pointLights[i / 10].position() - ray.origin;
        const Vector3 along = ray.direction.normalised();
        EXPECT_LT((toLight - along * toLight.dot(along)).magnitude(), RenderSettings{}.lightSize);
    }
}

TEST(ReferenceIlluminate, IsPhongsModelWhereTheLightIsFree) {
    seedRandom(1);
    Lit lit;
    illuminateOrigin(lit, penumbraScene(50.0));
    // N = L = (0, 1, 0), so that R is L and R.V is the viewer's height over its distance.
    const double arriving = 80.0 / (4.0 * std::numbers::pi * 16.0);
    const double gleam = std::pow(3.0 / std::sqrt(14.0), 10.0);
    const auto wanted = [&](double light) {
        return 0.5 * 0.02 + 0.5 * light * arriving * 0.8 + light * light * arriving * 1.2 * gleam;
    };
    EXPECT_NEAR(lit.colour.r, wanted(1.0), kReferenceRounding);
    EXPECT_NEAR(lit.colour.g, wanted(0.8), kReferenceRounding);
    EXPECT_NEAR(lit.colour.b, wanted(0.6), kReferenceRounding);
}

TEST(ReferenceIlluminate, LeavesTheAmbientLightInFullShadow) {
    Lit lit;
    illuminateOrigin(lit, penumbraScene(0.0));
    EXPECT_EQ(lit.colour, ColourRGB{0.5 * 0.02});
}

TEST(ReferenceIlluminate, IgnoresWhatLiesBeyondTheLight) {
    SceneDescription scene = penumbraScene(50.0);
    Lit free;
    illuminateOrigin(free, scene);
    scene.spheres[0].centre = {0, 7, 0};  // covers the light from behind
    Lit covered;
    illuminateOrigin(covered, scene);
    EXPECT_EQ(covered.colour, free.colour);
}

// The share of a uniform ball that the origin sees, by another generator and another intersection.
double visibleShare(const SceneDescription& scene, double lightSize, int samples) {
    std::mt19937_64 random{5};
    std::uniform_real_distribution<double> coordinate{-1.0, 1.0};
    const Vector3 start = kPoint + kUp * kShadowBias;
    int seen = 0;
    for (int i = 0; i < samples;) {
        const double x = coordinate(random);
        const double y = coordinate(random);
        const double z = coordinate(random);
        if (x * x + y * y + z * z > 1.0) continue;
        ++i;
        const Vector3 target = scene.pointLights[0].position() + Vector3{x, y, z} * lightSize;
        const Vector3 along = (target - start).normalised();
        const Vector3 toBall = scene.spheres[0].centre - start;
        seen += static_cast<int>((toBall - along * toBall.dot(along)).magnitude() > 1.0);
    }
    return static_cast<double>(seen) / samples;
}

TEST(ReferenceIlluminate, ScalesDiffuseAndSpecularByTheVisibleShare) {
    seedRandom(2);
    const SceneDescription scene = penumbraScene(1.12);
    RenderSettings settings;
    settings.shadowRayCount = 100'000;
    settings.lightSize = 0.7;
    const double share = visibleShare(scene, settings.lightSize, 100'000);
    ASSERT_TRUE(share > 0.2 && share < 0.8) << share;
    Lit free;
    illuminateOrigin(free, penumbraScene(50.0));
    Lit lit;
    illuminateOrigin(lit, scene, settings);
    const double ambient = 0.5 * 0.02;
    const double measured = (lit.colour.g - ambient) / (free.colour.g - ambient);
    // Two shares of 1e5 samples: standard deviation of the difference at most 0.0022; six of them
    // are exceeded with probability 2e-9.
    EXPECT_NEAR(measured, share, 0.0134);
    EXPECT_NEAR((lit.colour.r - ambient) / (free.colour.r - ambient), measured, kReferenceRounding);
}

// One pixel off the middle of the frame, so that distances along the ray and along z differ.
RenderSettings onePixel() {
    RenderSettings settings;
    settings.region = {600, 10, 1, 1};
    settings.seed = 3;
    settings.bounces = 0;
    return settings;
}

TEST(ReferenceRender, CastsItsRaysFromTheSquareThroughOneFocalPoint) {
    ticker::RecordingObserver observer;
    RenderSettings settings = onePixel();
    settings.dofRayCount = 400;
    settings.observer = &observer;
    static_cast<void>(Renderer{settings}.render(Scene{penumbraScene(1.0), &observer}));
    ASSERT_EQ(observer.tracedRays.size(), 400U);
    const Vector3 focalPoint =
        observer.cameraRay.direction * (settings.dofFocalPlane / observer.cameraRay.direction.z);
    Vector3 mean;
    double widest = 0.0;
    for (const Ray& ray : observer.tracedRays) {
        EXPECT_EQ(ray.origin.z, 0.0);
        EXPECT_LE(std::max(std::abs(ray.origin.x), std::abs(ray.origin.y)), settings.dofAmount);
        const Vector3 onPlane = ray.evaluateAt(settings.dofFocalPlane / ray.direction.z);
        EXPECT_LT((onPlane - focalPoint).magnitude(), kReferenceRounding);
        mean += ray.origin / 400;
        widest = std::max(widest, ray.origin.x * ray.origin.x + ray.origin.y * ray.origin.y);
    }
    // Uniform in [-0.2, 0.2]: standard deviation of a mean of 400 is 0.0058; six of them.
    EXPECT_LT(std::abs(mean.x), 0.035);
    EXPECT_LT(std::abs(mean.y), 0.035);
    // A share of 1 - pi / 4 lies outside the disc: none of 400 with probability 1e-42.
    EXPECT_GT(std::sqrt(widest), settings.dofAmount);
}

TEST(ReferenceRender, AveragesLinearColours) {
    ticker::RecordingObserver observer;
    RenderSettings settings = onePixel();
    settings.region = {320, 300, 1, 1};
    settings.observer = &observer;
    const Image image = Renderer{settings}.render(Scene{penumbraScene(1.0), &observer});
    ColourRGB sum;
    for (const ColourRGB& colour : observer.tracedColours)
        sum += colour;
    ASSERT_EQ(observer.tracedColours.size(), 50U);
    EXPECT_NEAR(image.at(0, 0).r, sum.r / 50, kReferenceRounding);
    EXPECT_NEAR(image.at(0, 0).b, sum.b / 50, kReferenceRounding);
}

TEST(ReferenceRender, RepeatsUnderASeedWhateverTheThreads) {
    RenderSettings settings;
    settings.width = 24;
    settings.height = 18;
    settings.dofRayCount = 4;
    settings.seed = 7;
    const Scene scene{penumbraScene(1.0)};
    const Image one = Renderer{settings}.render(scene);
    settings.threads = 4;
    EXPECT_EQ(Renderer{settings}.render(scene).pixels(), one.pixels());
    settings.region = {5, 6, 7, 8};
    const Image region = Renderer{settings}.render(scene);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 7; ++x)
            EXPECT_EQ(region.at(x, y), one.at(x + 5, y + 6));
    }
    settings.seed = 8;
    EXPECT_NE(Renderer{settings}.render(scene).pixels(), region.pixels());
}

}  // namespace
}  // namespace raytracer
