#include <grader/tasks/support/Bounds.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ticker::tasks {
namespace {

TEST(DkwBound, IsMassartsFormula) {
    EXPECT_NEAR(dkwBound(1000, 1e-8), std::sqrt(std::log(2e8) / 2000.0), 1e-12);
    EXPECT_EQ(dkwBound(0), 1.0);
}

TEST(MissedShare, LeavesExactlyTheRisk) {
    EXPECT_NEAR(std::pow(1.0 - missedShare(50, 1e-6), 50.0), 1e-6, 1e-12);
}

TEST(ChernoffTail, BoundsTheExactBinomial) {
    // P(no hit in 100 trials of chance 1/4) = 0.75^100, and the bound is exact there.
    EXPECT_NEAR(chernoffTail(0, 100, 0.25) / std::pow(0.75, 100.0), 1.0, 1e-9);
    EXPECT_NEAR(chernoffTail(25, 100, 0.25), 1.0, 1e-12);
}

TEST(LargestGap, IsZeroAtEvenStepsButForHalfAStep) {
    std::vector<double> even;
    for (int i = 0; i < 10; ++i)
        even.push_back((i + 0.5) / 10.0);
    EXPECT_NEAR(largestGap(even, [](double x) { return x; }), 0.05, 1e-12);
}

TEST(LargestGap, ComparesTwoSetsOfDifferentSizeAndScale) {
    std::vector<double> small;
    std::vector<double> large;
    for (int i = 0; i < 50; ++i)
        small.push_back(2.0 * (i + 0.5) / 50.0);
    for (int i = 0; i < 700; ++i)
        large.push_back((i + 0.5) / 700.0);
    EXPECT_LT(largestGap(small, large, 2.0), 0.03);
    EXPECT_GT(largestGap(small, large, 1.0), 0.4);
}

// The bound itself, at a risk large enough to count: 2000 experiments at risk 0.05 exceed it 100
// times at most on average; more than 150 times would have a chance below 1e-6.
TEST(DkwBound, HoldsForUniformSamples) {
    std::mt19937_64 engine{7};
    int exceeded = 0;
    for (int experiment = 0; experiment < 2000; ++experiment) {
        std::vector<double> samples(40);
        for (double& sample : samples)
            sample = static_cast<double>(engine() >> 11U) * 0x1p-53;
        if (largestGap(samples, [](double x) { return x; }) > dkwBound(40, 0.05)) ++exceeded;
    }
    EXPECT_LE(exceeded, 150);
    EXPECT_GE(exceeded, 20);
}

}  // namespace
}  // namespace ticker::tasks
