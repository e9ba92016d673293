#include <grader/metrics/Colours.h>
#include <grader/metrics/Compare.h>
#include <grader/metrics/Flip.h>

#include "MadePictures.h"

#include <gtest/gtest.h>

#include <set>

namespace ticker::metrics {
namespace {

Picture gradient() {
    return makePicture(96, 64, [](int x, int y) { return Rgb{2 * x, 3 * y, 120}; });
}

std::string summaryOf(const Picture& reference, const Picture& test) {
    return compare(reference.view(), test.view(), kUsualPixelsPerDegree).summary;
}

TEST(Compare, CallsTheSamePictureEqual) {
    EXPECT_EQ(summaryOf(gradient(), gradient()).rfind("equal: ", 0), 0U);
}

TEST(Compare, CallsTwoNoisyPicturesOfTheSameEqualUpToNoise) {
    EXPECT_EQ(
        summaryOf(withNoise(gradient(), 1), withNoise(gradient(), 2)).rfind("equal up to noise", 0),
        0U);
}

TEST(Compare, SaysWherePicturesDiffer) {
    Picture dented = withNoise(gradient(), 2);
    for (std::size_t y = 40; y < 64; ++y)
        for (std::size_t x = 0; x < 24; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                dented.rgb[(y * 96 + x) * 3 + c] = 0;
    const std::string summary = summaryOf(withNoise(gradient(), 1), dented);
    EXPECT_NE(summary.find("different beyond noise"), std::string::npos) << summary;
    EXPECT_NE(summary.find("towards the bottom left"), std::string::npos) << summary;
}

// An inverted relief: as bright on average, and smooth, but not noise.
TEST(Compare, TakesNoDetailForNoise) {
    const auto relief = [](int sign) {
        return makePicture(96, 64, [sign](int x, int y) {
            const int v = 120 + sign * (((x / 3 + y / 3) % 2) * 16 - 8);
            return Rgb{v, v, v};
        });
    };
    const Picture raised = relief(1);
    const Picture sunk = relief(-1);
    const Comparison comparison = compare(raised.view(), sunk.view(), kUsualPixelsPerDegree);
    EXPECT_EQ(comparison.outcome, Outcome::different) << comparison.summary;
    EXPECT_NE(comparison.sketch.find('~'), std::string::npos) << comparison.sketch;
}

TEST(Compare, CallsOneChangedPixelNearlyEqualAndSixteenDifferent) {
    Picture edited = gradient();
    edited.rgb[(30 * 96 + 40) * 3] ^= 64U;
    EXPECT_EQ(summaryOf(gradient(), edited).rfind("nearly equal: 1 of 6144 pixels differ", 0), 0U);
    for (std::size_t y = 30; y < 34; ++y)
        for (std::size_t x = 40; x < 44; ++x)
            edited.rgb[(y * 96 + x) * 3] = 255;
    const Comparison comparison = compare(gradient().view(), edited.view(), kUsualPixelsPerDegree);
    EXPECT_EQ(comparison.outcome, Outcome::different) << comparison.summary;
}

TEST(Compare, NamesEachRowOnce) {
    const Comparison comparison =
        compare(gradient().view(), gradient().view(), kUsualPixelsPerDegree);
    std::set<std::string> names;
    for (const Row& row : comparison.rows)
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_EQ(names.size(), 10U);
    const std::string text = table(comparison);
    for (const Row& row : comparison.rows)
        EXPECT_NE(text.find(row.title), std::string::npos) << row.title;
}

TEST(Score, OfEqualPicturesIsPerfectInEveryMetric) {
    const Scores scores = score(gradient().view(), gradient().view());
    EXPECT_EQ(scores.flip, 0.0);
    EXPECT_NEAR(scores.ssim, 1.0, 1e-6);
    EXPECT_NEAR(scores.gmsd, 0.0, 1e-6);
    EXPECT_EQ(scores.rmse, 0.0);
}

TEST(Magma, RunsFromBlackToPaleYellowAndGetsBrighterAllTheWay) {
    Map map{256, 1, {}};
    for (int i = 0; i < 256; ++i)
        map.values.push_back(static_cast<float>(i) / 255.0F);
    const std::vector<std::uint8_t> rgb = magma(map);
    // The ends as matplotlib has them: (0, 0, 3) and (251, 252, 191), to rounding.
    EXPECT_NEAR(rgb[0], 0, 1);
    EXPECT_NEAR(rgb[2], 3, 1);
    EXPECT_NEAR(rgb[255 * 3], 252, 1);
    EXPECT_NEAR(rgb[255 * 3 + 2], 191, 1);
    double before = -1.0;
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
        const double luma = 0.2126 * rgb[i] + 0.7152 * rgb[i + 1] + 0.0722 * rgb[i + 2];
        EXPECT_GE(luma, before - 0.5);
        before = luma;
    }
}

TEST(Magma, ShowsNotANumberAndTooMuchAsTheBrightest) {
    const std::vector<std::uint8_t> rgb = magma({3, 1, {NAN, 7.0F, 1.0F}});
    EXPECT_EQ(rgb[0], rgb[6]);
    EXPECT_EQ(rgb[3], rgb[6]);
}

TEST(BlueWhiteRed, IsWhiteAtZeroBlueBelowRedAbove) {
    const std::vector<std::uint8_t> rgb = blueWhiteRed({3, 1, {-2.0F, 0.0F, 2.0F}}, 2.0);
    EXPECT_GT(rgb[2], rgb[0]);
    EXPECT_EQ(rgb[3], 255);
    EXPECT_EQ(rgb[5], 255);
    EXPECT_GT(rgb[6], rgb[8]);
}

}  // namespace
}  // namespace ticker::metrics
