#include "RecordingObserver.h"

#include <raytracer/render/Renderer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

// With the template's hard shadows, so that nothing here is random.

namespace raytracer {
namespace {

constexpr double kRounding = 1e-12;

// A mirror below the light, and a plane above that closes the scene.
SceneDescription mirrorScene(double reflectivity) {
    SceneDescription scene;
    scene.ambientLighting = ColourRGB{0.1};
    scene.pointLights.push_back({{1, 2, 3}, {1.0, 0.9, 0.8}, 50});
    Material mirror;
    mirror.colour = {0.2, 0.4, 0.6};
    mirror.reflectivity = reflectivity;
    scene.planes.push_back({{0, -1, 0}, {0, 1, 0}, mirror});
    Material ceiling;
    ceiling.colour = {0.9, 0.1, 0.3};
    ceiling.reflectivity = 0.0;
    scene.planes.push_back({{0, 4, 0}, {0, -1, 0}, ceiling});
    return scene;
}

const Ray kDownwards{{}, Vector3{0, -1, 1}.normalised()};

void expectEqual(const ColourRGB& colour, const ColourRGB& wanted) {
    EXPECT_NEAR(colour.r, wanted.r, kRounding);
    EXPECT_NEAR(colour.g, wanted.g, kRounding);
    EXPECT_NEAR(colour.b, wanted.b, kRounding);
}

TEST(Trace, GivesTheBackgroundWhereNothingIsHit) {
    const Renderer renderer{RenderSettings{}};
    expectEqual(renderer.trace(Scene{SceneDescription{}}, kDownwards, 2), ColourRGB{0.001});
}

TEST(Trace, IsDirectLightAloneWithoutBounces) {
    const Renderer renderer{RenderSettings{}};
    const Scene scene{mirrorScene(0.3)};
    const RaycastHit hit = scene.findClosestIntersection(kDownwards).value();
    const ColourRGB direct =
        renderer.illuminate(scene, *hit.object, hit.location, hit.normal, kDownwards.origin);
    expectEqual(renderer.trace(scene, kDownwards, 0), direct);
    const Scene dull{mirrorScene(0.0)};
    expectEqual(renderer.trace(dull, kDownwards, 2), direct);
}

TEST(Trace, MixesDirectAndMirroredLight) {
    const Renderer renderer{RenderSettings{}};
    const Scene scene{mirrorScene(0.3)};
    const ColourRGB direct = renderer.trace(scene, kDownwards, 0);
    // Up again from (0, -1, 1), a bias above the mirror.
    const Ray up{{0, -1 + 1e-4, 1}, Vector3{0, 1, 1}.normalised()};
    const ColourRGB mirrored = renderer.trace(scene, up, 0);
    EXPECT_GT(mirrored.r, 1.5 * mirrored.g);  // it is the ceiling
    expectEqual(renderer.trace(scene, kDownwards, 1), direct * 0.7 + mirrored * 0.3);
}

TEST(Trace, FollowsAsManyReflectionsAsItIsTold) {
    SceneDescription scene = mirrorScene(0.5);
    scene.planes[1].material.reflectivity = 0.5;  // two mirrors that face each other
    for (int bounces = 0; bounces < 5; ++bounces) {
        ticker::RecordingObserver observer;
        RenderSettings settings;
        settings.observer = &observer;
        static_cast<void>(Renderer{settings}.trace(Scene{scene, &observer}, kDownwards, bounces));
        int traces = 0;
        for (const std::string& name : observer.names)
            traces += static_cast<int>(name.starts_with("traceBegan"));
        EXPECT_EQ(traces, bounces + 1);
    }
}

TEST(RenderObserver, SeesOnePixelInTheDocumentedOrder) {
    ticker::RecordingObserver observer;
    RenderSettings settings;
    settings.width = 1;
    settings.height = 1;
    settings.bounces = 1;
    settings.observer = &observer;
    SceneDescription description = mirrorScene(0.3);
    description.planes[0] = {{0, 0, 9}, {0, 1, -1}, description.planes[0].material};
    const Image image = Renderer{settings}.render(Scene{description, &observer});
    const std::vector<std::string> wanted{
        "cameraRayAsked",  "traceBegan 1",
        "rayCast hit",  // the mirror
        "illuminateBegan",
        "rayCast hit",  // past the light, the ceiling
        "illuminateEnded", "traceBegan 0",
        "rayCast hit",  // reflected to the ceiling
        "illuminateBegan",
        "rayCast miss",  // past the light, nothing
        "illuminateEnded", "traceEnded",   "traceEnded", "pixelSet",
    };
    EXPECT_EQ(observer.names, wanted);
    EXPECT_EQ(observer.rays[0].direction, observer.cameraRay.direction);
    EXPECT_EQ(image.width(), 1);
}

TEST(RenderObserver, DoesNotChangeThePicture) {
    ticker::RecordingObserver observer;
    RenderSettings settings;
    settings.width = 16;
    settings.height = 12;
    const SceneDescription description = mirrorScene(0.3);
    const Image alone = Renderer{settings}.render(Scene{description});
    settings.observer = &observer;
    const Image watched = Renderer{settings}.render(Scene{description, &observer});
    EXPECT_EQ(watched.pixels(), alone.pixels());
}

TEST(Render, OfARegionEqualsTheSamePixelsOfTheWhole) {
    RenderSettings settings;
    settings.width = 32;
    settings.height = 24;
    const Scene scene{mirrorScene(0.3)};
    const Image whole = Renderer{settings}.render(scene);
    settings.region = {7, 11, 9, 5};
    const Image region = Renderer{settings}.render(scene);
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 9; ++x)
            EXPECT_EQ(region.at(x, y), whole.at(x + 7, y + 11));
    }
}

}  // namespace
}  // namespace raytracer
