#include <grader/metrics/Difference.h>
#include <grader/metrics/Structure.h>

#include "MadePictures.h"

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace ticker::metrics {
namespace {

/// Four pixels, of which one differs by (3, 0, 4).
Picture four() {
    return flat(2, 2, {10, 20, 30});
}
Picture fourWithOneChanged() {
    Picture picture = four();
    picture.rgb[9] = 13;
    picture.rgb[11] = 34;
    return picture;
}

TEST(Rmse, IsTheRootOfTheMeanSquareOverAllChannels) {
    const Measured measured = rmse(four().view(), fourWithOneChanged().view());
    EXPECT_NEAR(measured.value, std::sqrt(25.0 / 12.0), 1e-6);
    EXPECT_EQ(measured.map.values[0], 0.0F);
    EXPECT_NEAR(measured.map.values[3], std::sqrt(25.0 / 3.0), 1e-6);
}

TEST(Psnr, OfADifferenceOf255IsZeroDecibelsAndOfEqualPicturesInfinite) {
    EXPECT_NEAR(psnr(flat(3, 3, {0, 0, 0}).view(), flat(3, 3, {255, 255, 255}).view()).value, 0.0,
                1e-9);
    EXPECT_EQ(psnr(four().view(), four().view()).value, INFINITY);
}

TEST(RelativeMse, WeighsDarkPlacesMore) {
    const double dark =
        relativeMse(flat(2, 2, {0, 0, 0}).view(), flat(2, 2, {51, 51, 51}).view()).value;
    EXPECT_NEAR(dark, 0.04 / 0.01, 1e-6);
    const double bright =
        relativeMse(flat(2, 2, {204, 204, 204}).view(), flat(2, 2, {255, 255, 255}).view()).value;
    EXPECT_NEAR(bright, 0.04 / 0.65, 1e-6);
}

TEST(LargestDifference, IsOfAnyChannelOfAnyPixel) {
    EXPECT_EQ(largestDifference(four().view(), fourWithOneChanged().view()).value, 4.0);
}

TEST(DifferingPixels, CountsPixelsBeyondTheTolerance) {
    EXPECT_EQ(differingPixels(four().view(), fourWithOneChanged().view()).value, 1.0);
    EXPECT_EQ(differingPixels(four().view(), fourWithOneChanged().view(), 3).value, 1.0);
    EXPECT_EQ(differingPixels(four().view(), fourWithOneChanged().view(), 4).value, 0.0);
}

// For two flat pictures only the means remain in the formula.
TEST(Ssim, OfFlatPicturesIsTheLuminanceTermAlone) {
    constexpr double kC1 = 6.5025;
    const double expected = (2.0 * 100 * 150 + kC1) / (100.0 * 100 + 150.0 * 150 + kC1);
    const Measured measured =
        ssim(flat(32, 24, {100, 100, 100}).view(), flat(32, 24, {150, 150, 150}).view());
    EXPECT_NEAR(measured.value, expected, 1e-4);  // rounding leaves variances of 1e-3
    EXPECT_EQ(measured.map.width, 32);
    EXPECT_EQ(measured.map.height, 24);
}

TEST(Ssim, FallsWithNoiseFromOne) {
    const Picture clean = makePicture(64, 48, [](int x, int y) { return Rgb{4 * x, 5 * y, 90}; });
    EXPECT_NEAR(ssim(clean.view(), clean.view()).value, 1.0, 1e-6);
    EXPECT_LT(ssim(clean.view(), withNoise(clean, 1).view()).value, 0.9);
}

TEST(Gmsd, IsZeroForEqualPicturesAndGrowsWithABlurredEdge) {
    const auto step = [](int x, int) { return x < 32 ? Rgb{20, 20, 20} : Rgb{220, 220, 220}; };
    const auto slope = [](int x, int) {
        const int v = 20 + 200 * std::clamp(x - 24, 0, 16) / 16;
        return Rgb{v, v, v};
    };
    const Picture sharp = makePicture(64, 48, step);
    EXPECT_NEAR(gmsd(sharp.view(), sharp.view()).value, 0.0, 1e-6);
    EXPECT_GT(gmsd(sharp.view(), makePicture(64, 48, slope).view()).value, 0.1);
}

TEST(EveryMetric, RefusesPicturesOfDifferentSizesAndBytesThatAreMissing) {
    const Picture wide = flat(5, 4, {0, 0, 0});
    const Picture tall = flat(4, 5, {0, 0, 0});
    const ByteView cut{5, 4, std::span{wide.rgb}.first(30)};
    const ByteView none{0, 0, {}};
    const std::function<Measured(const ByteView&, const ByteView&)> metrics[] = {
        rmse, psnr, relativeMse, largestDifference, ssim, gmsd};
    for (const auto& metric : metrics) {
        EXPECT_THROW((void)metric(wide.view(), tall.view()), raytracer::InputError);
        EXPECT_THROW((void)metric(wide.view(), cut), raytracer::InputError);
        EXPECT_THROW((void)metric(none, none), raytracer::InputError);
    }
}

}  // namespace
}  // namespace ticker::metrics
