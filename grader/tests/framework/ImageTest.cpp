#include <raytracer/base/Error.h>
#include <raytracer/image/Image.h>
#include <raytracer/image/ToneCurve.h>
#include <raytracer/scene/PointLight.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace raytracer {
namespace {

TEST(Image, KeepsLinearColoursUnclamped) {
    Image image{3, 2};
    image.set(2, 1, {4.0, -1.0, 0.5});
    EXPECT_EQ(image.at(2, 1), ColourRGB(4.0, -1.0, 0.5));
    EXPECT_EQ(image.pixels()[5], ColourRGB(4.0, -1.0, 0.5));
    EXPECT_EQ(image.at(0, 0), ColourRGB());
}

TEST(Image, HasTheSizeOfTheRegion) {
    RenderSettings settings;
    EXPECT_EQ(Image{settings}.width(), 640);
    EXPECT_EQ(Image{settings}.height(), 480);
    settings.region = {10, 20, 30, 40};
    EXPECT_EQ(Image{settings}.width(), 30);
    EXPECT_EQ(Image{settings}.height(), 40);
}

TEST(ImageSet, NamesThePixelThatIsOutsideAndTheSize) {
    Image image{3, 2};
    for (const auto& [x, y] : {std::pair{3, 0}, {0, 2}, {-1, 0}, {0, -1}}) {
        try {
            image.set(x, y, {});
            ADD_FAILURE() << x << ", " << y;
        } catch (const Error& error) {
            const std::string message = error.what();
            const std::string pixel = "(" + std::to_string(x) + ", " + std::to_string(y) + ")";
            EXPECT_NE(message.find(pixel), std::string::npos) << message;
            EXPECT_NE(message.find("3 x 2"), std::string::npos) << message;
        }
    }
}

TEST(Image, RefusesSizesThatNoPictureHas) {
    EXPECT_THROW(Image(0, 5), Error);
    EXPECT_THROW(Image(5, -1), Error);
    EXPECT_THROW(Image(65536, 1), Error);
}

TEST(ToneCurve, HasTheValuesOfItsFormula) {
    // 255 (p / (p + 0.25^1.3))^(1 / 2.2) with p = c^1.3, truncated; worked out by hand at c = 0.25,
    // where p / (p + p) = 1/2 and 255 / 2^(1 / 2.2) = 186.08.
    EXPECT_EQ(toneMapped(0.0), 0);
    EXPECT_EQ(toneMapped(0.25), 186);
    EXPECT_EQ(toneMapped(0.001), 9);  // the background, as the original has it
    // p = 1, 0.25^1.3 = 0.16494: 255 * 0.85842^(1 / 2.2) = 237.90
    EXPECT_EQ(toneMapped(1.0), 237);
}

TEST(ToneCurve, GivesAByteForEveryDouble) {
    const double huge = std::numeric_limits<double>::max();
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(toneMapped(huge), 255);
    EXPECT_EQ(toneMapped(1e240), 255);
    EXPECT_EQ(toneMapped(infinite), 255);
    EXPECT_EQ(toneMapped(-infinite), 0);
    EXPECT_EQ(toneMapped(-3.0), 0);
    EXPECT_EQ(toneMapped(std::numeric_limits<double>::quiet_NaN()), 0);
    EXPECT_EQ(toneMapped(std::numeric_limits<double>::denorm_min()), 0);
}

TEST(ToneCurve, NeverFalls) {
    int last = 0;
    for (double c = 0.0; c < 50.0; c = c * 1.01 + 1e-4) {
        const int byte = toneMapped(c);
        EXPECT_GE(byte, last);
        last = byte;
    }
    EXPECT_GT(last, 250);
}

TEST(PointLight, FallsOffWithTheSquareOfTheDistance) {
    const PointLight light{{}, {1.0, 0.5, 0.25}, 100.0};
    const ColourRGB near = light.illuminationAt(1.0);
    EXPECT_NEAR(near.r, 100.0 / (4.0 * std::numbers::pi), 1e-13);
    EXPECT_NEAR(near.b, 25.0 / (4.0 * std::numbers::pi), 1e-13);
    EXPECT_NEAR(light.illuminationAt(3.0).g * 9.0, near.g, 1e-13);
}

}  // namespace
}  // namespace raytracer
