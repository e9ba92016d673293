#include <grader/oracle/Oracle.h>
#include <grader/oracle/kernel/Kernel.h>
#include <grader/tests/oracle/TestScenes.h>

#include <gtest/gtest.h>
#include <hwy/highway.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace ticker::oracle::test {
namespace {

raytracer::RenderSettings settingsFor(int threads) {
    raytracer::RenderSettings settings;
    settings.width = 40;
    settings.height = 30;
    settings.threads = threads;
    return settings;
}

Precision fixedPaths(int paths) {
    Precision precision;
    precision.minLensPaths = precision.maxLensPaths = paths;
    return precision;
}

TEST(Oracle, GivesTheSamePictureWhateverTheThreads) {
    const auto one = Oracle{variedScene(), settingsFor(1)}.studentRender(7);
    const auto momentsOne = Oracle{variedScene(), settingsFor(1)}.moments(7);
    for (const int threads : {2, 4}) {
        const Oracle oracle{variedScene(), settingsFor(threads)};
        EXPECT_EQ(oracle.studentRender(7).pixels(), one.pixels());
        const Moments moments = oracle.moments(7);
        EXPECT_EQ(moments.mean, momentsOne.mean);
        EXPECT_EQ(moments.meanError, momentsOne.meanError);
        EXPECT_EQ(moments.lensPaths, momentsOne.lensPaths);
    }
}

TEST(Oracle, GivesAnotherPictureForAnotherSeed) {
    const Oracle oracle{distributedScene(), settingsFor(1)};
    EXPECT_NE(oracle.studentRender(7).pixels(), oracle.studentRender(8).pixels());
    EXPECT_NE(oracle.moments(7).mean, oracle.moments(8).mean);
}

TEST(Oracle, GivesARegionAsThePartOfTheWholePicture) {
    raytracer::RenderSettings settings = settingsFor(1);
    const Moments whole = Oracle{variedScene(), settings}.moments(3, fixedPaths(8192));
    settings.region = {10, 8, 12, 9};
    const Moments part = Oracle{variedScene(), settings}.moments(3, fixedPaths(8192));
    ASSERT_EQ(part.width, 12);
    ASSERT_EQ(part.height, 9);
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 12; ++x) {
            const auto own = static_cast<std::size_t>(y * 12 + x);
            const auto other = static_cast<std::size_t>((y + 8) * 40 + x + 10);
            // With 3 degrees of freedom each estimated error is rough, and may be far too small:
            // hence the constant.
            const double error = std::sqrt(part.meanError[own].g + whole.meanError[other].g) + 5e-4;
            EXPECT_NEAR(part.mean[own].g, whole.mean[other].g, 8.0 * error);
        }
}

/// Disables instruction sets during its lifetime.
class Without {
public:
    explicit Without(std::int64_t targets) { hwy::DisableTargets(targets); }
    ~Without() { hwy::DisableTargets(0); }
    Without(const Without&) = delete;
    Without& operator=(const Without&) = delete;
};

// The same sample points on every instruction set: differences come from rounding, and from rays
// that graze an edge (each counts 1 / paths of a pixel).
TEST(Oracle, GivesTheSameMeansOnEveryInstructionSet) {
    const Oracle oracle{variedScene(), settingsFor(1)};
    const Moments best = oracle.moments(7, fixedPaths(1024));
    const std::string bestName = instructionSet();
    for (const std::int64_t switchedOff :
         {std::int64_t{HWY_AVX3 | HWY_AVX3_DL}, std::int64_t{HWY_AVX3 | HWY_AVX3_DL | HWY_AVX2}}) {
        const Without without{switchedOff};
        if (bestName != instructionSet()) SCOPED_TRACE(instructionSet());
        const Moments other = oracle.moments(7, fixedPaths(1024));
        double squares = 0.0;
        double largest = 0.0;
        for (std::size_t i = 0; i < best.mean.size(); ++i) {
            const double off = std::abs(best.mean[i].g - other.mean[i].g);
            squares += off * off;
            largest = std::max(largest, off);
        }
        EXPECT_LT(std::sqrt(squares / static_cast<double>(best.mean.size())), 2e-5);
        EXPECT_LT(largest, 1e-3);  // one grazing path in 1024, as bright as a highlight
    }
}

}  // namespace
}  // namespace ticker::oracle::test
