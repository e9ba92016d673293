#include <grader/oracle/Bump.h>
#include <grader/tests/oracle/TestScenes.h>

#include <raytracer/geometry/BumpySphere.h>

#include <gtest/gtest.h>

#include <cmath>

namespace ticker::oracle::test {
namespace {

TEST(OracleBump, EqualsTheReferenceSolution) {
    const auto map = variedScene().spheres[0].heightMap;
    const raytracer::BumpySphere reference{{0.0, 0.0, 0.0}, 1.0, {}, map};
    for (int i = 0; i < 2000; ++i) {
        // A spiral over the sphere that avoids all texel edges.
        const double y = -0.999 + 1.998 * (i + 0.37) / 2000.0;
        const double turn = 2.399963 * i + 0.1;
        const double ring = std::sqrt(1.0 - y * y);
        const double point[3] = {ring * std::cos(turn), y, ring * std::sin(turn)};
        const raytracer::Vector3 expected = reference.getNormalAt({point[0], point[1], point[2]});
        const auto normal = bumpedNormal(*map, {}, point);
        EXPECT_NEAR(normal[0], expected.x, 1e-9);
        EXPECT_NEAR(normal[1], expected.y, 1e-9);
        EXPECT_NEAR(normal[2], expected.z, 1e-9);
    }
}

// Heights that rise to the right (or downwards) over the whole map: every accepted look-up tilts
// the normal to the left (upwards), except at the map's edge.
TEST(OracleBump, EveryReadingLeansBackAgainstASlope) {
    std::vector<double> right;
    std::vector<double> down;
    for (int row = 0; row < 32; ++row)
        for (int column = 0; column < 32; ++column) {
            right.push_back(5.0 * column / 31.0);
            down.push_back(5.0 * row / 31.0);
        }
    const raytracer::HeightMap rightwards{32, 32, right};
    const raytracer::HeightMap downwards{32, 32, down};
    const double point[3] = {0.1, 0.15, -std::sqrt(1.0 - 0.1 * 0.1 - 0.15 * 0.15)};
    for (const auto lookup : {BumpReading::Lookup::nearest, BumpReading::Lookup::bilinear})
        for (const auto difference :
             {BumpReading::Difference::forward, BumpReading::Difference::backward,
              BumpReading::Difference::central}) {
            BumpReading reading;
            reading.lookup = lookup;
            reading.difference = difference;
            EXPECT_LT(bumpedNormal(rightwards, reading, point)[0], point[0] - 0.05);
            EXPECT_GT(bumpedNormal(downwards, reading, point)[1], point[1] + 0.05);
            reading.mirrored = true;
            EXPECT_GT(bumpedNormal(rightwards, reading, point)[0], point[0] + 0.05);
        }
}

TEST(OracleBump, SwappedAxesTiltAlongTheOtherTangent) {
    std::vector<double> right;
    for (int row = 0; row < 32; ++row)
        for (int column = 0; column < 32; ++column)
            right.push_back(5.0 * column / 31.0);
    const raytracer::HeightMap rightwards{32, 32, right};
    const double point[3] = {0.1, 0.15, -std::sqrt(1.0 - 0.1 * 0.1 - 0.15 * 0.15)};
    BumpReading swapped;
    swapped.swapped = true;
    EXPECT_NEAR(bumpedNormal(rightwards, swapped, point)[0], point[0], 0.02);
    EXPECT_GT(bumpedNormal(rightwards, swapped, point)[1], point[1] + 0.05);
}

}  // namespace
}  // namespace ticker::oracle::test
