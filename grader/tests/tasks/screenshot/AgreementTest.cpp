#include <grader/tasks/screenshot/Agreement.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace ticker::tasks::screenshot {
namespace {

/// A ramp with equal normal noise in every channel.
Picture noisy(double deviation, std::uint64_t seed, double more = 0.0) {
    std::mt19937_64 generator{seed};
    std::normal_distribution<double> noise{0.0, 1.0};
    Picture picture{32, 64, {}};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double value = 60.0 + x + y + more + deviation * noise(generator);
            picture.rgb.insert(picture.rgb.end(), 3,
                               static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0)));
        }
    return picture;
}

// 300 pairs, of which each fails with a chance below 5e-4 by a conservative bound: more than one
// fails with a chance of 0.0102 at most.
TEST(Agreement, HoldsForHonestNoiseOfAnyStrength) {
    int failed = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed)
        for (const double deviation : {2.0, 10.0, 25.0})
            failed += agreementOf(noisy(deviation, seed).view(),
                                  noisy(deviation, seed + 1000).view(), true)
                              .agrees
                          ? 0
                          : 1;
    EXPECT_LE(failed, 1);
}

TEST(Agreement, HoldsForAPictureThatTookMoreRays) {
    EXPECT_TRUE(agreementOf(noisy(1.0, 1).view(), noisy(10.0, 2).view(), true).agrees);
    EXPECT_TRUE(agreementOf(noisy(0.0, 1).view(), noisy(10.0, 2).view(), true).agrees);
}

TEST(Agreement, EndsWhereBrightnessIsOffByAThirdOfTheNoise) {
    EXPECT_FALSE(agreementOf(noisy(10.0, 1, 3.5).view(), noisy(10.0, 2).view(), true).agrees);
}

TEST(Agreement, OfPicturesWithoutNoiseForgivesRoundingAndAFewPixels) {
    const Picture own = noisy(0.0, 1);
    Picture rounded = own;
    for (std::uint8_t& byte : rounded.rgb)
        byte = static_cast<std::uint8_t>(byte + 1);
    for (std::size_t i = 0; i < rounded.rgb.size(); i += 300)
        rounded.rgb[i] = 0;
    const Agreement agreement = agreementOf(rounded.view(), own.view(), false);
    EXPECT_TRUE(agreement.agrees);
    EXPECT_FALSE(agreement.isLossy);
    EXPECT_NEAR(agreement.differing, 0.01, 0.001);
}

TEST(Agreement, KnowsAPictureThatWasSavedWithLosses) {
    const Agreement agreement = agreementOf(noisy(4.0, 1).view(), noisy(0.0, 1).view(), false);
    EXPECT_TRUE(agreement.agrees);
    EXPECT_TRUE(agreement.isLossy);
    EXPECT_FALSE(agreementOf(noisy(10.0, 1).view(), noisy(0.0, 1).view(), false).agrees);
}

TEST(NoiseRatio, IsThatOfTheVariances) {
    const auto ratio = [](double first, double second) {
        return noiseRatio(noisy(first, 1).view(), noisy(second, 2).view());
    };
    EXPECT_NEAR(ratio(10.0, 10.0).value(), 1.0, 0.15);
    EXPECT_NEAR(ratio(5.0, 20.0).value(), 1.0 / 16.0, 0.02);
    EXPECT_EQ(ratio(0.0, 10.0).value(), 0.0);
    EXPECT_FALSE(ratio(10.0, 1.0)) << "nothing to compare with";
}

}  // namespace
}  // namespace ticker::tasks::screenshot
