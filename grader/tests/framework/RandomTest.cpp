#include <raytracer/math/Random.h>
#include <raytracer/math/Vector3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace raytracer {
namespace {

TEST(RandomBetween, NeverGivesTheUpperEnd) {
    seedRandom(2);
    // Nothing lies between these two, so that every other draw would round up to the end.
    const double low = 1.0;
    const double high = std::nextafter(low, 2.0);
    for (int i = 0; i < 1000; ++i)
        EXPECT_EQ(randomBetween(low, high), low);
}

TEST(SeedRandom, MakesDrawsRepeat) {
    const auto draws = [] {
        std::vector<double> values;
        seedRandom(3);
        for (int i = 0; i < 200; ++i) {
            values.push_back(randomBetween(0.0, 1.0));
            values.push_back(Vector3::randomInsideUnitSphere().y);
        }
        return values;
    };
    EXPECT_EQ(draws(), draws());
}

}  // namespace
}  // namespace raytracer
