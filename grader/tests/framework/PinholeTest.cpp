#include "PinholeRenderer.h"

#include <raytracer/image/ToneCurve.h>
#include <raytracer/io/SceneReader.h>
#include <raytracer/render/Renderer.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace raytracer {
namespace {

std::size_t pixelsApart(const Image& image, const std::vector<std::uint8_t>& wanted,
                        int tolerance) {
    std::size_t apart = 0;
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const std::array<std::uint8_t, 3> bytes = toneMapped(image.pixels()[i]);
        bool differs = false;
        for (std::size_t c = 0; c < 3; ++c)
            differs = differs || std::abs(bytes[c] - wanted[3 * i + c]) > tolerance;
        apart += static_cast<std::size_t>(differs);
    }
    return apart;
}

SceneDescription secondScene() {
    const std::string folder = TICKER_SOURCE_DIR;
    return readScene(folder + "/scenes/distributed.xml", folder + "/assets");
}

// The handout's first scene; the stub's normal is the smooth one, so that no map is needed.
SceneDescription firstScene() {
    SceneDescription scene;
    scene.ambientLighting = ColourRGB{5.0 / 255.0};
    scene.pointLights.push_back({{1, 3, 2}, ColourRGB{0xB3, 0xDD, 0xFF} / 255.0, 100});
    scene.pointLights.push_back({{-5, 1, 4}, ColourRGB{0xFF, 0xB0, 0xB2} / 255.0, 100});
    Material orange;
    orange.colour = ColourRGB{0xF4, 0x5B, 0x00} / 255.0;
    scene.spheres.push_back({{0, 0, 3.5}, 0.7, orange, nullptr});
    return scene;
}

// The template renders like the main tick, which the formulas describe.
std::size_t pixelsApartFromFormulas(const SceneDescription& scene) {
    RenderSettings settings;
    settings.threads = 2;
    const Image image = Renderer{settings}.render(Scene{scene});
    return pixelsApart(
        image, ticker::renderPinhole(scene, settings.width, settings.height, settings.bounces), 1);
}

// Rounding may move the edge of a shadow or a shape: 0.5 % of the pixels are granted for that.
constexpr std::size_t kGrantedPixels = 640 * 480 / 200;

TEST(PinholePicture, IsThatOfTheFormulasOnTheSecondScene) {
    const std::size_t apart = pixelsApartFromFormulas(secondScene());
    RecordProperty("pixelsApart", static_cast<int>(apart));
    EXPECT_LE(apart, kGrantedPixels);
}

TEST(PinholePicture, IsThatOfTheFormulasOnTheFirstScene) {
    const std::size_t apart = pixelsApartFromFormulas(firstScene());
    RecordProperty("pixelsApart", static_cast<int>(apart));
    EXPECT_LE(apart, kGrantedPixels);
}

TEST(PinholePicture, DiffersWhereOnePixelIsMoved) {
    const SceneDescription scene = secondScene();
    const int width = 160;
    const int height = 120;
    RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.region = {1, 0, width, height};
    const Image image = Renderer{settings}.render(Scene{scene});
    const std::vector<std::uint8_t> wanted = ticker::renderPinhole(scene, width, height, 2);
    EXPECT_GT(pixelsApart(image, wanted, 1) * 1000, image.pixels().size() * 5);
}

}  // namespace
}  // namespace raytracer
