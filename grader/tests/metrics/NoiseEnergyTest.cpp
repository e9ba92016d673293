#include <grader/metrics/NoiseEnergy.h>

#include "MadePictures.h"

#include <gtest/gtest.h>

namespace ticker::metrics {
namespace {

const Picture& clean() {
    static const Picture picture = makePicture(64, 32, [](int x, int y) {
        return Rgb{40 + 2 * x, 60 + 3 * y, 120};
    });
    return picture;
}

// Chernoff's bound against printed points of the chi-squared law with 10 degrees of freedom: 18.31
// is exceeded with a chance of 0.05, 29.59 with one of 0.001.
TEST(NoiseEnergy, BoundsTheTailOfTheChiSquaredLaw) {
    EXPECT_GT((NoiseEnergy{18.31, 10}.probability()), 0.05);
    EXPECT_GT((NoiseEnergy{29.59, 10}.probability()), 0.001);
    EXPECT_LT((NoiseEnergy{29.59, 10}.probability()), 0.02);
    EXPECT_EQ((NoiseEnergy{9.0, 10}.probability()), 1.0);
    EXPECT_EQ((NoiseEnergy{0.0, 0}.probability()), 1.0);
}

// 32 tiles; 200 pairs, each with a chance of 1e-6.
TEST(NoiseEnergy, OfTwoNoisyPicturesOfTheSameIsAboutTheNumberOfTiles) {
    double sum = 0.0;
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        const NoiseEnergy energy =
            noiseEnergy(withNoise(clean(), seed).view(), withNoise(clean(), seed + 1000).view());
        EXPECT_EQ(energy.tiles, 32);
        EXPECT_GT(energy.probability(), 1e-6) << seed;
        sum += energy.energy / 200.0;
    }
    // Standard error of this mean: sqrt(2 * 32 / 200) = 0.57.
    EXPECT_NEAR(sum, 32.0, 3.5);
}

TEST(NoiseEnergy, AddsUpFaintDifferencesThatNoTileShowsAlone) {
    Picture brighter = clean();
    for (std::uint8_t& value : brighter.rgb)
        value = static_cast<std::uint8_t>(value + 3);
    const NoiseEnergy energy =
        noiseEnergy(withNoise(clean(), 1).view(), withNoise(brighter, 2).view());
    EXPECT_LT(energy.probability(), 1e-6);
}

TEST(NoiseEnergy, ForgivesOneStepOfRounding) {
    Picture rounded = clean();
    for (std::size_t i = 0; i < rounded.rgb.size(); i += 7)
        ++rounded.rgb[i];
    EXPECT_GT(noiseEnergy(clean().view(), rounded.view()).probability(), 0.1);
}

}  // namespace
}  // namespace ticker::metrics
