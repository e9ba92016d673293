#include <grader/lab/calibrate/RateBounds.h>

#include <gtest/gtest.h>

#include <cmath>

namespace ticker::calibrate {
namespace {

TEST(UpperBound, IsTheRuleOfThreeWhereNothingHappened) {
    EXPECT_NEAR(upperBound(0, 20000), 3.0 / 20000, 1e-6);
    EXPECT_NEAR(upperBound(0, 6000), 1.0 - std::pow(0.05, 1.0 / 6000), 1e-12);
}

// 3 of 10: 0.6066, the one-sided limit in tables of Clopper and Pearson.
TEST(UpperBound, IsClopperAndPearsonsElsewhere) {
    EXPECT_NEAR(upperBound(3, 10), 0.6066, 1e-4);
    EXPECT_NEAR(upperBound(1, 100), 0.0466, 1e-4);
}

TEST(UpperBound, IsOneWhereNothingIsKnown) {
    EXPECT_EQ(upperBound(0, 0), 1.0);
    EXPECT_EQ(upperBound(5, 5), 1.0);
}

TEST(UpperBound, HoldsForCountsWhosePowersVanish) {
    EXPECT_NEAR(upperBound(5000, 100000), 0.0512, 2e-4);
}

}  // namespace
}  // namespace ticker::calibrate
