#include <grader/metrics/Flip.h>

#include "MadePictures.h"

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

// The expected values were measured with the authors' own tool, version 1.6, for pictures defined
// by formula. They have six digits; 1e-4 is the largest difference that another order of summation
// in single precision makes.
namespace ticker::metrics {
namespace {

constexpr double kTolerance = 1e-4;
constexpr int kWidth = 128;
constexpr int kHeight = 96;

struct Pair {
    Picture reference;
    Picture test;
};

Rgb ramp(int x, int y) {
    return {255 * x / 127, 255 * y / 95, 128};
}
Rgb checker(int x, int y) {
    const int value = (x / 8 + y / 8) % 2 == 1 ? 255 : 0;
    return {value, value, value};
}
Rgb ball(int x, int y, double brightness) {
    const double squared = (x - 64) * (x - 64) + (y - 48) * (y - 48);
    if (squared > 1600.0) return {9, 9, 9};
    const double z = std::sqrt(1600.0 - squared) / 40.0;
    return {static_cast<int>(brightness * 245.0 * z), static_cast<int>(brightness * 91.0 * z), 0};
}

Pair rampPair() {
    return {makePicture(kWidth, kHeight, ramp), makePicture(kWidth, kHeight, [](int x, int y) {
                return ramp(std::min(x + 3, 127), y);
            })};
}
Pair checkerPair() {
    return {makePicture(kWidth, kHeight, checker),
            makePicture(kWidth, kHeight, [](int x, int y) { return checker(x + 1, y); })};
}
Pair noisePair() {
    const Picture clean = flat(kWidth, kHeight, {120, 80, 40});
    return {clean, withNoise(clean, 1)};
}
Pair ballPair() {
    return {makePicture(kWidth, kHeight, [](int x, int y) { return ball(x, y, 1.0); }),
            makePicture(kWidth, kHeight, [](int x, int y) { return ball(x, y, 0.8); })};
}

struct Expected {
    std::string name;
    Pair (*make)();
    double pixelsPerDegree;
    double mean, median, first, third, largest;
};

void PrintTo(const Expected& expected, std::ostream* stream) {
    *stream << expected.name << " at " << expected.pixelsPerDegree;
}

class FlipOfPublishedPairs : public testing::TestWithParam<Expected> {};

TEST_P(FlipOfPublishedPairs, EqualsTheAuthorsTool) {
    const Expected& expected = GetParam();
    const Pair pair = expected.make();
    const Measured measured =
        flip(pair.reference.view(), pair.test.view(), expected.pixelsPerDegree);
    const WeightedQuartiles quartiles = weightedQuartiles(measured.map);
    EXPECT_NEAR(measured.value, expected.mean, kTolerance);
    EXPECT_NEAR(quartiles.median, expected.median, kTolerance);
    EXPECT_NEAR(quartiles.first, expected.first, kTolerance);
    EXPECT_NEAR(quartiles.third, expected.third, kTolerance);
    EXPECT_NEAR(largestOf(measured.map), expected.largest, kTolerance);
}

constexpr double kUsual = 67.0206;
INSTANTIATE_TEST_SUITE_P(
    All, FlipOfPublishedPairs,
    testing::Values(
        Expected{"ramp", rampPair, kUsual, 0.083168, 0.102895, 0.080173, 0.117226, 0.145811},
        Expected{"ramp", rampPair, 40.0, 0.082602, 0.102187, 0.079793, 0.116542, 0.150359},
        Expected{"checker", checkerPair, kUsual, 0.323045, 0.533466, 0.398173, 0.696402, 0.993284},
        Expected{"checker", checkerPair, 40.0, 0.289106, 0.803005, 0.435806, 0.882908, 0.994308},
        Expected{"noise", noisePair, kUsual, 0.078152, 0.085527, 0.067431, 0.104805, 0.213893},
        Expected{"noise", noisePair, 40.0, 0.116847, 0.127100, 0.102818, 0.152005, 0.252569},
        Expected{"ball", ballPair, kUsual, 0.188558, 0.510929, 0.421040, 0.570889, 0.603869},
        Expected{"ball", ballPair, 40.0, 0.182963, 0.505475, 0.416245, 0.566752, 0.602144}));

TEST(Flip, OfBlackAndWhiteEqualsTheAuthorsTool) {
    for (const int side : {1, 7, 40}) {
        const Measured measured =
            flip(flat(side, side, {0, 0, 0}).view(), flat(side, side, {255, 255, 255}).view());
        EXPECT_NEAR(measured.value, 0.967345, kTolerance) << side;
        EXPECT_NEAR(largestOf(measured.map), 0.967388, kTolerance) << side;
    }
}

TEST(Flip, OfGreenAndBlueIsOne) {
    EXPECT_NEAR(flip(flat(9, 5, {0, 255, 0}).view(), flat(9, 5, {0, 0, 255}).view()).value, 1.0,
                kTolerance);
}

TEST(Flip, OfEqualPicturesIsExactlyZeroEverywhere) {
    const Pair pair = ballPair();
    const Measured measured = flip(pair.reference.view(), pair.reference.view());
    EXPECT_EQ(measured.value, 0.0);
    EXPECT_EQ(largestOf(measured.map), 0.0F);
}

TEST(Flip, DoesNotCareWhichPictureIsTheReference) {
    const Pair pair = checkerPair();
    EXPECT_NEAR(flip(pair.reference.view(), pair.test.view()).value,
                flip(pair.test.view(), pair.reference.view()).value, 1e-6);
}

TEST(Flip, SaysBothSizesWherePicturesDifferInSize) {
    try {
        (void)flip(flat(4, 5, {0, 0, 0}).view(), flat(5, 4, {0, 0, 0}).view());
        FAIL();
    } catch (const raytracer::InputError& error) {
        EXPECT_NE(std::string{error.what()}.find("4 x 5 and 5 x 4"), std::string::npos)
            << error.what();
    }
}

TEST(Flip, RefusesAViewingDistanceThatIsNone) {
    const Picture picture = flat(4, 4, {1, 2, 3});
    for (const double bad : {0.0, -1.0, 1e9, std::nan("")})
        EXPECT_THROW((void)flip(picture.view(), picture.view(), bad), raytracer::InputError);
}

TEST(PixelsPerDegree, OfTheUsualMonitorIsTheUsualNumber) {
    EXPECT_NEAR(pixelsPerDegree(0.7, 0.7, 3840), kUsualPixelsPerDegree, 1e-9);
}

}  // namespace
}  // namespace ticker::metrics
