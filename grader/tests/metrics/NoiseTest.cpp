#include <grader/metrics/Noise.h>
#include <grader/metrics/StudentT.h>

#include "MadePictures.h"

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <random>

namespace ticker::metrics {
namespace {

/// Mean and variance of `renders` pictures of independent normal pixels around `level`.
Moments moments(int width, int height, int renders, double level, std::uint64_t seed) {
    std::mt19937_64 generator{seed};
    std::normal_distribution<double> noise{0.0, 0.3};
    Moments result{static_cast<double>(renders), {width, height, {}}, {width, height, {}}};
    for (int i = 0; i < width * height; ++i) {
        double sum = 0.0;
        double squares = 0.0;
        for (int r = 0; r < renders; ++r) {
            const double value = noise(generator);
            sum += value;
            squares += value * value;
        }
        const double mean = sum / renders;
        result.mean.values.push_back(static_cast<float>(level + mean));
        result.variance.values.push_back(
            static_cast<float>((squares - renders * mean * mean) / (renders - 1)));
    }
    return result;
}

// Percentage points from printed tables.
TEST(StudentT, TailsEqualThoseOfPrintedTables) {
    EXPECT_NEAR(twoSidedTail(12.706, 1), 0.05, 1e-5);
    EXPECT_NEAR(twoSidedTail(2.228, 10), 0.05, 1e-4);
    EXPECT_NEAR(twoSidedTail(4.587, 10), 0.001, 1e-6);
    EXPECT_NEAR(twoSidedTail(1.959964, 1e7), 0.05, 1e-6);
    EXPECT_EQ(twoSidedTail(0.0, 5), 1.0);
    EXPECT_EQ(twoSidedTail(INFINITY, 5), 0.0);
}

TEST(StudentT, TailsAreRightFarOut) {
    // With one degree of freedom the tail is that of Cauchy: 2 atan(1 / t) / pi.
    EXPECT_NEAR(twoSidedTail(1e8, 1) / (2e-8 / std::acos(-1.0)), 1.0, 1e-6);
}

// 400 tiles of equal renders at a false-alarm rate of 1e-6 for the whole picture.
TEST(WelchTiles, FindNothingInEqualRenders) {
    const TileTest test = welchTiles(moments(160, 160, 8, 0.5, 1), moments(160, 160, 5, 0.5, 2), 8);
    EXPECT_EQ(test.differing, 0);
    EXPECT_GT(test.smallest, 1e-6);
}

// The probabilities of 6400 tiles of 16 pixels, with 2 renders each, must be uniform: 5 % of them,
// 320, are below 0.05; the binomial standard deviation is 17.4, and 6 of them are exceeded with
// probability 2e-9.
TEST(WelchTiles, GiveUniformProbabilitiesForEqualRenders) {
    const TileTest test = welchTiles(moments(320, 320, 8, 0.5, 3), moments(320, 320, 8, 0.5, 4), 4);
    int below = 0;
    for (const float p : test.probability.values)
        below += p < 0.05F ? 1 : 0;
    EXPECT_NEAR(below, 320, 105);
}

TEST(WelchTiles, FindTheTileThatIsBrighterAndSayItIs) {
    const Moments reference = moments(64, 64, 8, 0.5, 5);
    Moments test = moments(64, 64, 8, 0.5, 6);
    for (int y = 16; y < 32; ++y)
        for (int x = 32; x < 48; ++x)
            test.mean.values[static_cast<std::size_t>(y * 64 + x)] += 0.1F;
    const TileTest tiles = welchTiles(reference, test, 16);
    EXPECT_EQ(tiles.differing, 1);
    EXPECT_GT(tiles.score.values[1 * 4 + 2], 6.0F);
}

TEST(WelchTiles, TakeAnyDifferenceWithoutNoiseForReal) {
    Moments reference{4.0, {2, 2, {1, 1, 1, 1}}, {2, 2, {0, 0, 0, 0}}};
    Moments test = reference;
    EXPECT_EQ(welchTiles(reference, test, 2).differing, 0);
    test.mean.values[3] = 1.25F;
    EXPECT_EQ(welchTiles(reference, test, 2).differing, 1);
    EXPECT_EQ(welchTiles(reference, test, 1).differing, 1);
}

TEST(WelchTiles, RefuseASingleRender) {
    const Moments one = moments(4, 4, 2, 0.5, 7);
    Moments single = one;
    single.renders = 1.0;
    EXPECT_THROW((void)welchTiles(one, single, 2), raytracer::InputError);
    EXPECT_THROW((void)welchTiles(one, one, 0), raytracer::InputError);
}

// 60 pairs at 1e-6 each.
TEST(NoiseTiles, FindNothingInTwoNoisyPicturesOfTheSame) {
    const Picture clean = makePicture(96, 64, [](int x, int y) { return Rgb{2 * x, 3 * y, 200}; });
    for (std::uint32_t seed = 1; seed <= 60; ++seed)
        EXPECT_EQ(noiseTiles(withNoise(clean, seed).view(), withNoise(clean, seed + 1000).view())
                      .differing,
                  0)
            << seed;
}

TEST(NoiseTiles, FindAFaintPatchUnderStrongNoise) {
    const Picture clean = flat(96, 64, {100, 100, 100});
    const Picture patched = makePicture(96, 64, [](int x, int y) {
        const int v = x >= 64 && y < 32 ? 106 : 100;
        return Rgb{v, v, v};
    });
    const TileTest test = noiseTiles(withNoise(clean, 1).view(), withNoise(patched, 2).view());
    EXPECT_GT(test.differing, 0);
    EXPECT_LE(test.differing, 16);
    EXPECT_GT(test.score.values[4], 5.0F) << "the patch is brighter in the second picture";
    EXPECT_EQ(test.smallest < 1e-6, true);
}

TEST(NoiseTiles, OfEqualPicturesHaveNothingToSay) {
    const Picture picture = withNoise(flat(20, 20, {50, 60, 70}), 1);
    const TileTest test = noiseTiles(picture.view(), picture.view());
    EXPECT_EQ(test.differing, 0);
    EXPECT_EQ(test.smallest, 1.0);
}

TEST(ZMap, CountsStandardErrorsOfBothSides) {
    const Moments reference{4.0, {2, 1, {1.0F, 1.0F}}, {2, 1, {0.16F, 0.0F}}};
    // 0.16 (1 + 1/4) = 0.2, and the floor 0.01 (1 + 1/4) = 0.0125.
    const Measured z = zMap(reference, {2, 1, {2.0F, 1.5F}}, 1.0, 0.01);
    EXPECT_NEAR(z.map.values[0], 1.0 / std::sqrt(0.2), 1e-6);
    EXPECT_NEAR(z.map.values[1], 0.5 / std::sqrt(0.0125), 1e-5);
    EXPECT_NEAR(z.value, 0.5 / std::sqrt(0.0125), 1e-5);
}

TEST(ZMap, LetsNotANumberThroughInsteadOfCallingItEqual) {
    const Moments reference{4.0, {2, 1, {1.0F, 1.0F}}, {2, 1, {1.0F, 1.0F}}};
    EXPECT_TRUE(std::isnan(zMap(reference, {2, 1, {1.0F, NAN}}, 1.0).value));
}

}  // namespace
}  // namespace ticker::metrics
