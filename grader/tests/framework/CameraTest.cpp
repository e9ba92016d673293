#include <raytracer/scene/Camera.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

constexpr double kPixelRounding = 1e-15;  // a few steps of a double near 1

RenderSettings sized(int width, int height) {
    RenderSettings settings;
    settings.width = width;
    settings.height = height;
    return settings;
}

TEST(Camera, LooksAlongZThroughTheMiddleOfAnOddFrame) {
    const Ray ray = Camera{sized(3, 5)}.castRay(1, 2);
    EXPECT_EQ(ray.origin, Vector3{});
    EXPECT_EQ(ray.direction, Vector3(0, 0, 1));
}

TEST(Camera, CastsThroughThePixelsMiddle) {
    // One pixel spans the whole field of view: its middle is straight ahead.
    EXPECT_EQ(Camera{sized(1, 1)}.castRay(0, 0).direction, Vector3(0, 0, 1));
    const Vector3 left = Camera{sized(2, 2)}.castRay(0, 0).direction;
    const double half = std::tan(std::numbers::pi / 8.0) / 2.0;  // middle of the left half
    EXPECT_NEAR(left.x / left.z, -half, kPixelRounding);
    EXPECT_NEAR(left.y / left.z, half, kPixelRounding);
}

TEST(Camera, SpansFortyFiveDegreesAcrossTheWidthWhateverTheHeight) {
    for (const int height : {1, 480, 2000}) {
        const int width = 640;
        const Camera camera{sized(width, height)};
        const Vector3 first = camera.castRay(0, 0).direction;
        const Vector3 second = camera.castRay(1, 0).direction;
        const double pitch = second.x / second.z - first.x / first.z;
        const double leftEdge = first.x / first.z - pitch / 2.0;
        EXPECT_NEAR(std::atan(-leftEdge), std::numbers::pi / 8.0, 1e-13);
        EXPECT_NEAR(pitch * width, 2.0 * std::tan(std::numbers::pi / 8.0), 1e-12);
    }
}

TEST(Camera, HasSquarePixelsAndTheTopRowFirst) {
    const Camera camera{sized(8, 6)};
    const Vector3 here = camera.castRay(3, 2).direction;
    const Vector3 right = camera.castRay(4, 2).direction;
    const Vector3 below = camera.castRay(3, 3).direction;
    const double toTheRight = right.x / right.z - here.x / here.z;
    const double downwards = here.y / here.z - below.y / below.z;
    EXPECT_GT(toTheRight, 0.0);
    EXPECT_NEAR(toTheRight, downwards, kPixelRounding);
}

TEST(Camera, GivesUnitDirections) {
    const Camera camera{sized(64, 48)};
    for (int x = 0; x < 64; x += 7)
        EXPECT_NEAR(camera.castRay(x, x % 48).direction.magnitude(), 1.0, kPixelRounding);
}

TEST(Camera, OfARegionEqualsTheSamePixelsOfTheWhole) {
    RenderSettings cut = sized(640, 480);
    cut.region = {100, 37, 20, 10};
    const Camera whole{sized(640, 480)};
    const Camera region{cut};
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 20; ++x)
            EXPECT_EQ(region.castRay(x, y).direction, whole.castRay(x + 100, y + 37).direction);
    }
}

}  // namespace
}  // namespace raytracer
