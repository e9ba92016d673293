// The numbers behind the judgement of pictures, worked out by hand for pictures of a few pixels.
#include <grader/tasks/lens/answers/Pictures.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ticker::tasks {
namespace {

// Smallest variance of a pixel, see varianceFloor in Pictures.cpp.
constexpr double kFloor = 3.0 / 4096 * 0.25 / 50.0;

/// Three renders of two pixels, of means 2 and 4 and variances 1 and 4.
SeenPictures threeRenders() {
    SeenPictures seen;
    seen.renders = {{1.0, 2.0}, {2.0, 4.0}, {3.0, 6.0}};
    seen.mean = {2.0, 4.0};
    seen.variance = {1.0, 4.0};
    seen.width = 2;
    return seen;
}

/// One render of these pixels.
SeenPictures oneRender(const Plane& pixels, int width) {
    SeenPictures seen;
    seen.renders = {pixels};
    seen.mean = pixels;
    seen.variance = Plane(pixels.size(), 0.0);
    seen.identical = true;
    seen.width = width;
    return seen;
}

TEST(ReadPictures, WeighsChannelsAndTakesMeanAndVarianceOverTheRepetitions) {
    probe::RenderAnswer answer;
    answer.width = 2;
    answer.height = 1;
    answer.images = {{{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, {{0.0, 1.0, 0.0}, {0.0, 0.0, 2.0}}};
    const SeenPictures seen = readPictures(answer);
    EXPECT_FALSE(seen.identical);
    EXPECT_EQ(seen.width, 2);
    EXPECT_NEAR(seen.renders.at(0).at(0), 0.35, 1e-12);
    EXPECT_NEAR(seen.renders.at(1).at(0), 0.4, 1e-12);
    EXPECT_NEAR(seen.renders.at(1).at(1), 0.5, 1e-12);
    EXPECT_NEAR(seen.mean.at(0), 0.375, 1e-12);
    EXPECT_NEAR(seen.variance.at(0), 0.05 * 0.05 / 2.0, 1e-12);
    EXPECT_NEAR(seen.variance.at(1), 0.5 * 0.5 / 2.0, 1e-12);
    answer.images[1] = answer.images[0];
    EXPECT_TRUE(readPictures(answer).identical);
    answer.images.pop_back();
    EXPECT_EQ(readPictures(answer).variance.at(0), 0.0);
}

TEST(MatchOf, IsTheMatchedFilter) {
    const ExpectedPicture expected{{1.0, 1.0}, {1.5, 9.0}, {0.5, 1.0}};
    // Variances of the means: 1.5 / 3 + 0.5 = 1 and 9 / 3 + 1 = 4; differences 1 and 4, weights 1
    // and 1; the filter's results for the renders are 3, 6 and 9, with variance 9, where 1 + 4 is
    // expected.
    const Match match = matchOf(threeRenders(), expected, {2.0, 5.0});
    EXPECT_NEAR(match.z, (1.0 + 3.0) / std::sqrt(1.0 + 4.0), 1e-12);
    EXPECT_NEAR(match.amplitude, 4.0 / 5.0, 1e-12);
    EXPECT_NEAR(match.spread, 9.0 / 5.0, 1e-12);
    EXPECT_EQ(matchOf(threeRenders(), expected, expected.mean).amplitude, 0.0);
}

TEST(MatchOf, CountsPicturesThatAreOneAsOne) {
    const ExpectedPicture expected{{1.0, 1.0}, {0.5, 3.0}, {0.5, 1.0}};
    const Match match = matchOf(oneRender({2.0, 4.0}, 2), expected, {2.0, 5.0});
    EXPECT_NEAR(match.z, 4.0 / std::sqrt(5.0), 1e-12);
    EXPECT_EQ(match.spread, 0.0);
}

TEST(LargestTileZ, SumsTilesOfSixByWhichTheLastAreSmaller) {
    const ExpectedPicture expected{Plane(56, 1.0), Plane(56, 0.75), Plane(56, 0.25)};
    Plane pixels(56, 1.0);
    EXPECT_EQ(largestTileZ(oneRender(pixels, 8), expected), 0.0);
    for (std::size_t y = 0; y < 6; ++y)
        for (std::size_t x = 0; x < 6; ++x)
            pixels[8 * y + x] = 1.5;
    EXPECT_NEAR(largestTileZ(oneRender(pixels, 8), expected), 36 * 0.5 / 6.0, 1e-12);
    pixels[54] = pixels[55] = -2.0;
    EXPECT_NEAR(largestTileZ(oneRender(pixels, 8), expected), 6.0 / std::sqrt(2.0), 1e-12);
    pixels[54] = 4.0;
    EXPECT_NEAR(largestTileZ(oneRender(pixels, 8), expected), 3.0, 1e-12);
}

TEST(ExcessVariance, ComparesThePixelsThatHaveNoise) {
    SeenPictures seen = threeRenders();
    seen.variance = {3.0, 100.0, 2.0};
    const ExpectedPicture expected{{}, {1.0 + kFloor, 3.9 * kFloor, 2.0 + kFloor}, {}};
    const Excess excess = excessVariance(seen, expected);
    EXPECT_NEAR(excess.ratio, (3.0 + 1.0) / 2.0, 1e-9);
    EXPECT_NEAR(excess.z, 2.0 / std::sqrt(2.0 * 2.0 / 2.0), 1e-9);
    const ExpectedPicture barely{{}, Plane(3, 4.1 * kFloor), {}};
    EXPECT_NEAR(excessVariance(seen, barely).ratio * 3.1 * kFloor, 105.0 / 3.0, 1e-6);
    const ExpectedPicture still{{}, Plane(3, kFloor), {}};
    EXPECT_EQ(excessVariance(seen, still).ratio, 1.0);
    seen.identical = true;
    EXPECT_EQ(excessVariance(seen, expected).z, 0.0);
}

TEST(UnexplainedBy, IsTheShareOfTheSquaredDifferenceThatIsLeft) {
    const SeenPictures seen = oneRender({1.0, 2.0}, 2);
    const ExpectedPicture expected{{0.0, 0.0}, {1.0, 1.0}, {0.0, 0.0}};
    EXPECT_NEAR(unexplainedBy({1.0, 1.0}, seen, expected), 1.0 / 5.0, 1e-12);
    EXPECT_NEAR(unexplainedBy({0.0, 1.5}, seen, expected), 1.25 / 5.0, 1e-12);
    EXPECT_EQ(unexplainedBy({0.0, 0.0}, seen, {{1.0, 2.0}, {}, {}}), 1.0) << "nothing to explain";
}

TEST(Rescaled, IsTheExpectedPictureTimesWhatFitsBest) {
    const ExpectedPicture expected{{1.0, 2.0}, {}, {}};
    const auto scaled = [&](const Plane& seen) { return rescaled(oneRender(seen, 2), expected); };
    ASSERT_TRUE(scaled({0.5, 2.0}));
    EXPECT_NEAR(scaled({0.5, 2.0})->at(1), 2.0 * (0.5 + 4.0) / 5.0, 1e-12);
    ASSERT_TRUE(scaled({1.02, 2.04}));
    EXPECT_NEAR(scaled({1.02, 2.04})->at(0), 1.02, 1e-12);
    EXPECT_FALSE(scaled({1.005, 2.01})) << "it fits as it is";
    EXPECT_FALSE(scaled({0.0005, 0.001})) << "black";
    EXPECT_TRUE(scaled({0.002, 0.004}));
}

TEST(MeanSquaredZ, IsOneWhereEachPixelIsOffByItsDeviation) {
    const ExpectedPicture expected{{1.0, 1.0}, {3.0, 0.5}, {1.0, 0.5}};
    EXPECT_NEAR(meanSquaredZ(oneRender({3.0, 0.0}, 2), expected), 1.0, 1e-12);
    EXPECT_NEAR(meanSquaredZ(oneRender({5.0, 1.0}, 2), expected), 2.0, 1e-12);
}

TEST(ZMap, IsFullAtEightDeviations) {
    const ExpectedPicture expected{Plane(4, 1.0), Plane(4, 0.75), Plane(4, 0.25)};
    const Raster map = zMap(oneRender({5.0, 1.0, -1.0, 30.0}, 2), expected);
    EXPECT_EQ(map.width, 2);
    EXPECT_EQ(map.height, 2);
    EXPECT_EQ(map.values, (std::vector<float>{0.5F, 0.0F, -0.25F, 1.0F}));
}

TEST(SeenPictures, AreFiniteWhereEveryPixelIs) {
    SeenPictures seen = threeRenders();
    EXPECT_TRUE(seen.isFinite());
    seen.mean[1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(seen.isFinite());
}

}  // namespace
}  // namespace ticker::tasks
