// Limits between agreement and difference, by hand.
#include <grader/tasks/screenshot/Agreement.h>
#include <grader/tasks/screenshot/Relief.h>
#include <grader/tasks/screenshot/Whole.h>
#include <grader/tasks/screenshot/Windows.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ticker::tasks::screenshot {
namespace {

/// 200 x 150 pixels of grey: 20 x 15 tiles of ten pixels.
Picture grey() {
    return {200, 150, std::vector<std::uint8_t>(std::size_t{3} * 200 * 150, 100)};
}

/// Adds `by` to one channel of one tile.
void change(Picture& picture, int column, int row, std::size_t channel, int by) {
    for (int y = 10 * row; y < 10 * row + 10; ++y)
        for (int x = 10 * column; x < 10 * column + 10; ++x) {
            std::uint8_t& byte = picture.rgb[static_cast<std::size_t>(3 * (y * 200 + x)) + channel];
            byte = static_cast<std::uint8_t>(byte + by);
        }
}

TEST(TileDifference, IsMeasuredTileByTile) {
    Picture changed = grey();
    change(changed, 3, 9, 0, 12);
    change(changed, 3, 9, 2, -6);
    change(changed, 17, 2, 1, 30);
    change(changed, 5, 5, 1, -15);
    const TileDifference difference = tileDifference(grey().view(), changed.view());
    EXPECT_NEAR(difference.worst, 10.0, 1e-9);
    EXPECT_NEAR(difference.worstX, 0.875, 1e-9);
    EXPECT_NEAR(difference.worstY, 2.5 / 15.0, 1e-9);
    EXPECT_EQ(difference.tilesOff, 2) << "by six and by ten";
    EXPECT_NEAR(difference.rms, std::sqrt((144.0 + 36.0 + 900.0 + 225.0) / (3.0 * 20.0 * 15.0)),
                1e-9);
    EXPECT_EQ(tileDifference(changed.view(), grey().view()).worst, difference.worst);
}

TEST(ColourChange, IsFoundOfEachChannelByItself) {
    Picture from = grey();
    Picture to = grey();
    for (std::size_t i = 0; i < from.rgb.size(); i += 3) {
        const std::size_t tile = i / 3 % 200 / 10 + 20 * (i / 600 / 10);
        from.rgb[i] = static_cast<std::uint8_t>(tile % 20 * 12);
        from.rgb[i + 1] = static_cast<std::uint8_t>(tile / 20 * 16);
        from.rgb[i + 2] = static_cast<std::uint8_t>(tile * 7 % 250);
        to.rgb[i] = static_cast<std::uint8_t>(255 - from.rgb[i]);
        to.rgb[i + 1] = static_cast<std::uint8_t>(from.rgb[i + 2] / 2 + 20);
        to.rgb[i + 2] =
            static_cast<std::uint8_t>(from.rgb[i + 1] * from.rgb[i + 1] / 255 + from.rgb[i] / 8);
    }
    const Picture made = ColourChange{from.view(), to.view()}.appliedTo(from.view());
    for (std::size_t i = 0; i < made.rgb.size(); ++i)
        ASSERT_NEAR(made.rgb[i], to.rgb[i], 2) << i;
}

Picture strip(int differing, int by) {
    Picture picture{20, 50, std::vector<std::uint8_t>(3000, 100)};
    for (int i = 0; i < differing; ++i)
        picture.rgb[static_cast<std::size_t>(3 * i)] = static_cast<std::uint8_t>(100 + by);
    return picture;
}

TEST(Agreement, WithoutNoiseEndsAtThreeStepsInOneOfFiftyPixelsOrAnErrorOfSix) {
    const auto compare = [](int differing, int by) {
        return agreementOf(strip(differing, by).view(), strip(0, 0).view(), false);
    };
    EXPECT_FALSE(compare(1000, 3).isLossy) << "three steps are rounding";
    EXPECT_EQ(compare(1000, 3).differing, 0.0);
    EXPECT_FALSE(compare(20, 4).isLossy);
    EXPECT_NEAR(compare(20, 4).differing, 0.02, 1e-9);
    EXPECT_TRUE(compare(21, 4).isLossy);
    EXPECT_TRUE(compare(1000, 10).agrees) << "an error of 10 / sqrt(3)";
    EXPECT_NEAR(compare(1000, 10).rms, 10.0 / std::sqrt(3.0), 1e-6);
    EXPECT_FALSE(compare(1000, 11).agrees);
    EXPECT_TRUE(compare(20, 150).agrees) << "a few pixels may be anything";
}

TEST(Relief, IsTheSameSofterOrRatherAnother) {
    EXPECT_TRUE(isSame({0.86, 1.0}));
    EXPECT_FALSE(isSame({0.84, 1.0}));
    EXPECT_TRUE(isSofter({0.31, 0.74}));
    EXPECT_FALSE(isSofter({0.29, 0.74}));
    EXPECT_FALSE(isSofter({0.31, 0.76}));
    EXPECT_TRUE(isRather({0.31, 1.0}, {0.15, 1.0}));
    EXPECT_FALSE(isRather({0.29, 1.0}, {0.1, 1.0}));
    EXPECT_FALSE(isRather({0.5, 1.0}, {0.26, 1.0}));
}

TEST(SensibleSize, EndsAtFourThirdsOfAPixel) {
    EXPECT_TRUE(isSensibleSize(320, 239));
    EXPECT_TRUE(isSensibleSize(320, 241));
    EXPECT_FALSE(isSensibleSize(320, 242));
    EXPECT_FALSE(isSensibleSize(320, 238));
    EXPECT_FALSE(isSensibleSize(319, 239));
}

TEST(Windows, LieRoundTheirPlacesAndTheSecondStageBeside) {
    double spread[2] = {0.0, 0.0};
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const metrics::Box one = drawWindows(true, 640, 480, seed).boxes.at(0);
        EXPECT_NEAR(one.x + 32, 380, 6.5);
        EXPECT_NEAR(one.y + 20, 185, 6.5);
        spread[0] = std::max(spread[0], std::abs(one.x + 32 - 380.0));
        EXPECT_EQ(drawWindows(true, 640, 480, seed, 1).boxes.at(0).x, one.x + 12);
        const metrics::Box lens = drawWindows(false, 1280, 960, seed).boxes.at(2);
        EXPECT_NEAR(lens.x + 8, 2 * 576, 4.5);
        EXPECT_NEAR(lens.y + 8, 2 * 384, 4.5);
        spread[1] = std::max(spread[1], std::abs(lens.y + 8 - 768.0));
        EXPECT_EQ(drawWindows(false, 1280, 960, seed, 1).boxes.at(2).x, lens.x + 25);
        EXPECT_EQ(drawWindows(false, 1280, 960, seed, 1).boxes.at(2).y, lens.y);
    }
    EXPECT_GE(spread[0], 5.0);
    EXPECT_GE(spread[1], 3.0);
}

}  // namespace
}  // namespace ticker::tasks::screenshot
