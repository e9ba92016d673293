#include <raytracer/math/Random.h>
#include <raytracer/math/Vector3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <thread>
#include <vector>

// The seeds are fixed, so that a test that passes once always passes. The stated rates apply to a
// fresh seed: a failure after a change of the generator is not bad luck.

namespace raytracer {
namespace {

constexpr int kDraws = 200'000;

// Largest distance of the sorted values' distribution from the uniform one, times the root of
// their number. Kolmogorov: above 3.2 with probability 2 exp(-2 * 3.2^2) = 2.6e-9.
double kolmogorov(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto n = static_cast<double>(values.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto rank = static_cast<double>(i);
        largest = std::max({largest, (rank + 1.0) / n - values[i], values[i] - rank / n});
    }
    return largest * std::sqrt(n);
}

constexpr double kKolmogorovBound = 3.2;

std::vector<double> unitDraws(int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(randomBetween(0.0, 1.0));
    return values;
}

TEST(RandomBetween, IsUniform) {
    seedRandom(1);
    EXPECT_LT(kolmogorov(unitDraws(kDraws)), kKolmogorovBound);
}

TEST(RandomBetween, HasUncorrelatedNeighbours) {
    seedRandom(2);
    const std::vector<double> values = unitDraws(kDraws);
    double sum = 0.0;
    for (std::size_t i = 1; i < values.size(); ++i)
        sum += (values[i] - 0.5) * (values[i - 1] - 0.5) * 12.0;
    // Nearly normal with variance 1: beyond 6 sigma with probability 2e-9.
    EXPECT_LT(std::abs(sum) / std::sqrt(kDraws), 6.0);
}

TEST(RandomBetween, StaysInItsHalfOpenRange) {
    seedRandom(3);
    for (int i = 0; i < 10'000; ++i) {
        const double value = randomBetween(-0.2, 0.2);
        EXPECT_TRUE(value >= -0.2 && value < 0.2) << value;
    }
}

TEST(RandomBetween, NeverGivesTheUpperEnd) {
    seedRandom(4);
    // No double lies between these two, so that every other draw would round up to the end.
    const double low = 1.0;
    const double high = std::nextafter(low, 2.0);
    for (int i = 0; i < 1000; ++i)
        EXPECT_EQ(randomBetween(low, high), low);
}

TEST(SeedRandom, MakesDrawsRepeat) {
    const auto draws = [] {
        std::vector<double> values;
        seedRandom(5);
        for (int i = 0; i < 200; ++i) {
            values.push_back(randomBetween(0.0, 1.0));
            values.push_back(Vector3::randomInsideUnitSphere().y);
        }
        return values;
    };
    const std::vector<double> first = draws();
    static_cast<void>(Vector3::randomInsideUnitSphere());  // leaves points made ahead
    EXPECT_EQ(draws(), first);
}

TEST(SeedRandom, SetsTheCallingThreadAlone) {
    seedRandom(6);
    const double expected = randomBetween(0.0, 1.0);
    seedRandom(6);
    std::thread{[] { seedRandom(7); }}.join();
    EXPECT_EQ(randomBetween(0.0, 1.0), expected);
}

TEST(Random, DiffersBetweenUnseededThreads) {
    std::array<double, 3> draws{};
    for (double& draw : draws)
        std::thread{[&draw] { draw = randomBetween(0.0, 1.0); }}.join();
    EXPECT_NE(draws[0], draws[1]);
    EXPECT_NE(draws[1], draws[2]);
    EXPECT_NE(draws[0], draws[2]);
}

std::vector<Vector3> ballPoints(std::uint64_t seed) {
    seedRandom(seed);
    std::vector<Vector3> points;
    for (int i = 0; i < kDraws; ++i)
        points.push_back(Vector3::randomInsideUnitSphere());
    return points;
}

TEST(RandomInsideUnitSphere, StaysInTheBall) {
    for (const Vector3& point : ballPoints(8))
        EXPECT_LT(point.dot(point), 1.0);
}

TEST(RandomInsideUnitSphere, HasUniformCubesOfTheRadius) {
    std::vector<double> cubes;
    for (const Vector3& point : ballPoints(9))
        cubes.push_back(std::pow(point.magnitude(), 3.0));
    EXPECT_LT(kolmogorov(std::move(cubes)), kKolmogorovBound);
}

// The height of a uniform direction along any axis is uniform (Archimedes).
TEST(RandomInsideUnitSphere, PointsInAllDirectionsAlike) {
    const std::vector<Vector3> points = ballPoints(10);
    const Vector3 axes[] = {{1, 0, 0},
                            {0, 1, 0},
                            {0, 0, 1},
                            Vector3{1, 1, 1}.normalised(),
                            Vector3{1, -2, 0.5}.normalised()};
    for (const Vector3& axis : axes) {
        std::vector<double> heights;
        for (const Vector3& point : points)
            heights.push_back(0.5 + 0.5 * point.normalised().dot(axis));
        EXPECT_LT(kolmogorov(std::move(heights)), kKolmogorovBound);
    }
}

TEST(RandomInsideUnitSphere, HasTheMomentsOfTheBall) {
    const std::vector<Vector3> points = ballPoints(11);
    Vector3 mean;
    double xx = 0.0;
    double xy = 0.0;
    double neighbours = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3& p = points[i];
        mean += p;
        xx += p.x * p.x;
        xy += p.x * p.y;
        if (i > 0) neighbours += p.dot(points[i - 1]);
    }
    // E x^2 = 1/5, var x^2 = 3/35 - 1/25 = 8/175, E (xy)^2 = 1/35, E (p.q)^2 = 3/25; six standard
    // deviations of the sums, each beyond with probability 2e-9.
    const double n = kDraws;
    const double six = 6.0 * std::sqrt(n);
    EXPECT_LT(std::abs(mean.x), six * std::sqrt(1.0 / 5.0));
    EXPECT_LT(std::abs(mean.y), six * std::sqrt(1.0 / 5.0));
    EXPECT_LT(std::abs(mean.z), six * std::sqrt(1.0 / 5.0));
    EXPECT_LT(std::abs(xx - n / 5.0), six * std::sqrt(8.0 / 175.0));
    EXPECT_LT(std::abs(xy), six * std::sqrt(1.0 / 35.0));
    EXPECT_LT(std::abs(neighbours), six * std::sqrt(3.0 / 25.0));
}

TEST(RandomInsideUnitSphere, IsAsUniformRightAfterASeed) {
    // forEachPixel reseeds for every pixel: the first points of many seeds must be uniform too.
    std::vector<double> cubes;
    std::vector<double> heights;
    for (std::uint64_t seed = 0; seed < 50'000; ++seed) {
        seedRandom(seed);
        const Vector3 point = Vector3::randomInsideUnitSphere();
        cubes.push_back(std::pow(point.magnitude(), 3.0));
        heights.push_back(0.5 + 0.5 * point.normalised().z);
    }
    EXPECT_LT(kolmogorov(std::move(cubes)), kKolmogorovBound);
    EXPECT_LT(kolmogorov(std::move(heights)), kKolmogorovBound);
}

}  // namespace
}  // namespace raytracer
