#include <grader/metrics/Alignment.h>
#include <grader/oracle/references/References.h>
#include <grader/tasks/screenshot/Relief.h>

#include <raytracer/geometry/HeightMap.h>
#include <raytracer/image/ToneCurve.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace ticker::tasks::screenshot {
namespace {

/// A ball whose height map has waves of this height.
raytracer::SceneDescription wavyBall(double height) {
    std::vector<double> heights;
    for (int row = 0; row < 64; ++row)
        for (int column = 0; column < 128; ++column)
            heights.push_back(height * (1.0 + std::sin(column * 0.4) * std::cos(row * 0.3)));
    raytracer::SceneDescription scene;
    scene.ambientLighting = raytracer::ColourRGB{0.1};
    scene.pointLights.emplace_back(raytracer::Vector3{2.0, 3.0, 0.0}, raytracer::ColourRGB{1.0},
                                   300.0);
    scene.spheres.push_back({{0.0, 0.0, 4.0},
                             1.2,
                             {raytracer::ColourRGB{0.7, 0.5, 0.3}},
                             std::make_shared<const raytracer::HeightMap>(128, 64, heights)});
    return scene;
}

Picture pictureOf(const raytracer::SceneDescription& description) {
    raytracer::RenderSettings settings;
    settings.width = 160;
    settings.height = 120;
    Picture picture{settings.width, settings.height, {}};
    const raytracer::Image image = oracle::renderPinholeWithOracle(description, settings);
    for (const raytracer::ColourRGB& colour : image.pixels())
        for (const std::uint8_t byte : raytracer::toneMapped(colour))
            picture.rgb.push_back(byte);
    return picture;
}

/// How much a picture of waves of height `seen` resembles one of code that draws height `own`.
Relief reliefBetween(double seen, double own) {
    const raytracer::SceneDescription description = wavyBall(0.4);
    const Picture ownPicture = pictureOf(wavyBall(own));
    Scene scene;
    scene.description = &description;
    scene.own = ownPicture.view();
    return reliefOf(pictureOf(wavyBall(seen)).view(), scene);
}

TEST(ReliefOf, IsTheSameReliefWithTheSameStrengthInTheSamePicture) {
    const Relief same = reliefBetween(0.4, 0.4);
    EXPECT_NEAR(same.likeness, 1.0, 1e-9);
    EXPECT_NEAR(same.strength, 1.0, 1e-9);
    EXPECT_TRUE(isSame(same));
}

TEST(ReliefOf, TellsASofterReliefAndAnInvertedOne) {
    const Relief softer = reliefBetween(0.1, 0.4);
    EXPECT_GT(softer.likeness, 0.7);
    EXPECT_TRUE(isSofter(softer)) << softer.strength;
    EXPECT_LT(reliefBetween(-0.4, 0.4).likeness, 0.5);
}

}  // namespace
}  // namespace ticker::tasks::screenshot
