#include <student_template/framework/app/PixelStory.h>
#include <student_template/framework/app/SceneWords.h>

#include <raytracer/render/Renderer.h>

#include <gtest/gtest.h>

#include <string>

namespace raytracer {
namespace {

/// A mirror ball above a floor under two lights, one of them hidden by a plane.
SceneDescription scene() {
    SceneDescription scene;
    scene.ambientLighting = ColourRGB{0.1};
    scene.pointLights.emplace_back(Vector3{0.0, 5.0, 0.0}, ColourRGB{1.0}, 100.0);
    scene.pointLights.emplace_back(Vector3{0.0, -5.0, 0.0}, ColourRGB{1.0}, 100.0);
    Material material;
    material.colour = ColourRGB{0.5};
    scene.spheres.push_back({{0.0, 0.0, 4.0}, 1.0, material, nullptr});
    scene.planes.push_back({{0.0, -2.0, 0.0}, {0.0, 1.0, 0.0}, material});
    return scene;
}

RenderSettings onePixel(RenderObserver* observer) {
    RenderSettings settings;
    settings.width = 64;
    settings.height = 48;
    settings.region = {32, 24, 1, 1};
    settings.dofRayCount = 5;
    settings.observer = observer;
    return settings;
}

TEST(PixelLog, HoldsEveryRayInItsPlace) {
    PixelLog log;
    const Scene watched{scene(), &log};
    const Image image = Renderer{onePixel(&log)}.render(watched);

    ASSERT_EQ(log.traced().size(), 5U);
    EXPECT_TRUE(log.loose().empty());
    ASSERT_TRUE(log.pixel());
    EXPECT_EQ(*log.pixel(), image.at(0, 0));
    const TracedRay& first = log.traced().front();
    ASSERT_TRUE(first.hit);
    EXPECT_EQ(first.bouncesLeft, 2);
    EXPECT_EQ(first.shadowRays.size(), 20U);
    ASSERT_EQ(first.reflected.size(), 1U);
    EXPECT_EQ(first.reflected.front().bouncesLeft, 1);
    const ColourRGB mixed = *first.direct * 0.7 + first.reflected.front().colour * 0.3;
    EXPECT_NEAR(first.colour.g, mixed.g, 1e-12);
}

TEST(SceneWords, CountTheRaysThatArrive) {
    EXPECT_EQ(arrivingText(0), "0 arrive");
    EXPECT_EQ(arrivingText(1), "1 arrives");
    EXPECT_EQ(arrivingText(2), "2 arrive");
}

TEST(PixelLog, IsToldInWords) {
    PixelLog log;
    const Scene watched{scene(), &log};
    static_cast<void>(Renderer{onePixel(&log)}.render(watched));
    const std::string story = storyOf(log, watched, false);

    for (const std::string part :
         {"camera ray 1 from", "meets sphere 1 at", "ambient light (0.05, 0.05, 0.05)",
          "light 1: 10 shadow rays, ", "light 2: 10 shadow rays, 0 arrive", "without any shadow",
          "illuminate gives", "reflected ray from", "camera ray 5 from", "the pixel becomes",
          "--verbose"})
        EXPECT_NE(story.find(part), std::string::npos) << part << "\n" << story;
    EXPECT_EQ(storyOf(log, watched, true).find("--verbose"), std::string::npos);
}

TEST(PixelLog, TellsOfASolutionThatDoesNothing) {
    PixelLog log;
    const std::string story = storyOf(log, Scene{scene()}, false);

    EXPECT_NE(story.find("trace was never called"), std::string::npos) << story;
    EXPECT_NE(story.find("the pixel was never set"), std::string::npos) << story;
}

}  // namespace
}  // namespace raytracer
