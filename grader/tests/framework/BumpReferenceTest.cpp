#include <raytracer/geometry/BumpySphere.h>
#include <raytracer/math/Random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string_view>
#include <vector>

// Properties of the model answer for T1.

namespace raytracer {
namespace {

constexpr int kSide = 64;
constexpr double kMiddle = kBumpFactor / 2.0;
constexpr double kRounding = 1e-9;  // of atan2, acos and back, times slopes of up to 5

const Vector3 kCentre{0.3, -0.2, 3.5};
constexpr double kRadius = 0.7;

/// A point of the sphere and the directions of the map there: right is towards larger columns, down
/// towards larger rows.
struct Place {
    Vector3 position;
    Vector3 normal;
    Vector3 right;
    Vector3 down;
};

// The reference's parametrisation: column 0 behind, the middle column in front, row 0 on top.
Place placeAt(double u, double v) {
    const double longitude = (u - 0.5) * 2.0 * std::numbers::pi;
    const double polar = v * std::numbers::pi;
    const Vector3 normal{std::sin(longitude) * std::sin(polar), std::cos(polar),
                         -std::cos(longitude) * std::sin(polar)};
    const Vector3 right{std::cos(longitude), 0.0, std::sin(longitude)};
    const Vector3 down{std::sin(longitude) * std::cos(polar), -std::sin(polar),
                       -std::cos(longitude) * std::cos(polar)};
    return {kCentre + normal * kRadius, normal, right, down};
}

Place middleOf(int column, int row) {
    return placeAt((column + 0.5) / kSide, (row + 0.5) / kSide);
}

using Heights = std::vector<double>;

double& heightAt(Heights& heights, int column, int row) {
    return heights[static_cast<std::size_t>(row * kSide + column)];
}

BumpySphere sphereWith(const Heights& heights) {
    return {kCentre, kRadius, {}, std::make_shared<const HeightMap>(kSide, kSide, heights)};
}

// A letter of 5 x 5 strokes, each 4 texels wide, at `height` over the mid grey around it.
void drawLetter(Heights& heights, const std::array<std::string_view, 5>& letter, int left, int top,
                double height) {
    for (int row = 0; row < 20; ++row) {
        for (int column = 0; column < 20; ++column) {
            const auto line = static_cast<std::size_t>(row / 4);
            const auto stroke = static_cast<std::size_t>(column / 4);
            if (letter[line][stroke] == '#') heightAt(heights, left + column, top + row) = height;
        }
    }
}

Heights raisedHAndLoweredL() {
    Heights heights(kSide * kSide, kMiddle);
    drawLetter(heights, {"#...#", "#...#", "#####", "#...#", "#...#"}, 8, 22, kBumpFactor);
    drawLetter(heights, {"#....", "#....", "#....", "#....", "#####"}, 36, 22, 0.0);
    return heights;
}

TEST(ReferenceNormal, RaisesTheHAndLowersTheL) {
    const BumpySphere sphere = sphereWith(raisedHAndLoweredL());
    const auto lean = [&sphere](int column, int row) {
        const Place place = middleOf(column, row);
        const Vector3 normal = sphere.getNormalAt(place.position);
        return std::pair{normal.dot(place.right), normal.dot(place.down)};
    };
    // The last texel before a stroke that rises to its right leans left; before one that rises
    // below it, up. For a stroke that sinks, and where a stroke ends, the directions are opposite.
    EXPECT_LT(lean(7, 23).first, -0.5);    // into the H from the left
    EXPECT_GT(lean(11, 23).first, 0.5);    // out of its first stroke
    EXPECT_LT(lean(9, 21).second, -0.5);   // into the H from above
    EXPECT_GT(lean(9, 41).second, 0.5);    // out of it below
    EXPECT_GT(lean(35, 30).first, 0.5);    // into the L from the left
    EXPECT_LT(lean(39, 30).first, -0.5);   // out of its first stroke
    EXPECT_GT(lean(37, 21).second, 0.5);   // into the L from above
    EXPECT_LT(lean(50, 41).second, -0.5);  // out of it below
}

TEST(ReferenceNormal, LeansAgainstBothSlopesEverywhere) {
    seedRandom(1);
    Heights heights(kSide * kSide);
    for (double& height : heights)
        height = randomBetween(0.0, kBumpFactor);
    const BumpySphere sphere = sphereWith(heights);
    for (int row = 0; row + 1 < kSide; ++row) {
        for (int column = 0; column < kSide; ++column) {
            const Place place = middleOf(column, row);
            const Vector3 normal = sphere.getNormalAt(place.position);
            const double here = heightAt(heights, column, row);
            const double right = heightAt(heights, (column + 1) % kSide, row);  // round the seam
            const double below = heightAt(heights, column, row + 1);
            const double outwards = normal.dot(place.normal);
            EXPECT_NEAR(normal.dot(place.right) / outwards, here - right, kRounding);
            EXPECT_NEAR(normal.dot(place.down) / outwards, here - below, kRounding);
        }
    }
}

TEST(ReferenceNormal, IsTheSmoothOneOnAFlatMap) {
    const BumpySphere sphere = sphereWith(Heights(kSide * kSide, 2.0));
    for (double v = 0.01; v < 1.0; v += 0.07) {
        const Place place = placeAt(std::fmod(v * 7.3, 1.0), v);
        const Vector3 apart = sphere.getNormalAt(place.position) - place.normal;
        EXPECT_LT(apart.magnitude(), kRounding);
    }
}

TEST(ReferenceNormal, HasUnitLengthEverywhere) {
    seedRandom(2);
    Heights heights(kSide * kSide);
    for (double& height : heights)
        height = randomBetween(0.0, 1.0) < 0.5 ? 0.0 : kBumpFactor;
    const BumpySphere sphere = sphereWith(heights);
    for (int i = 0; i < 20'000; ++i) {
        const Vector3 outwards = Vector3::randomInsideUnitSphere().normalised();
        const Vector3 normal = sphere.getNormalAt(kCentre + outwards * kRadius);
        EXPECT_NEAR(normal.magnitude(), 1.0, 1e-12);
        EXPECT_GT(normal.dot(outwards), 0.0);  // never turned inwards
    }
}

TEST(ReferenceNormal, IsFiniteAtThePolesAndAlongTheSeam) {
    const BumpySphere sphere = sphereWith(raisedHAndLoweredL());
    std::vector<Vector3> directions{{0, 1, 0},  {0, -1, 0},   {0, 0, 1},    {0, 0, -1},  {1, 0, 0},
                                    {-1, 0, 0}, {-0.0, 1, 0}, {0, 1, -0.0}, {-0.0, 0, 1}};
    for (const double tiny : {1e-300, 1e-17, 1e-9}) {
        directions.push_back({tiny, 1, tiny});
        directions.push_back({-tiny, -1, tiny});
        directions.push_back({tiny, 0.3, 1});  // right behind: the two sides of the seam
        directions.push_back({-tiny, 0.3, 1});
    }
    // Also round the origin, where rounding does not remove exact zeros.
    const BumpySphere central{
        {}, 1.0, {}, std::make_shared<const HeightMap>(kSide, kSide, raisedHAndLoweredL())};
    for (const Vector3& direction : directions) {
        for (const BumpySphere* bumpy : {&sphere, &central}) {
            const Vector3 position = bumpy->centre() + direction.normalised() * bumpy->radius();
            EXPECT_NEAR(bumpy->getNormalAt(position).magnitude(), 1.0, 1e-12);
        }
    }
}

// NOTES.md: of the 16 choices of the directions of Pu and Pv and the signs of Bu and Bv, with a
// plus before both cross products, 4 are right, 8 invert one axis, 4 invert both.
TEST(PlusBeforeBothCrossProducts, IsRightForFourOfSixteenChoices) {
    const Place place = placeAt(0.4, 0.45);
    std::array<int, 3> invertedAxes{};
    for (unsigned choice = 0; choice < 16; ++choice) {
        const double signPu = (choice & 1U) != 0 ? 1.0 : -1.0;
        const double signPv = (choice & 2U) != 0 ? 1.0 : -1.0;
        const double signBu = (choice & 4U) != 0 ? 1.0 : -1.0;
        const double signBv = (choice & 8U) != 0 ? 1.0 : -1.0;
        const Vector3 Pu = place.right * signPu;
        const Vector3 Pv = place.down * signPv;
        // A map that rises to the right and downwards by one; Bu and Bv are its slopes along Pu
        // and Pv, or the negatives.
        const double Bu = signBu * signPu;
        const double Bv = signBv * signPv;
        const Vector3 tilted =
            place.normal + Bu * place.normal.cross(Pv) + Bv * place.normal.cross(Pu);
        const int inverted = static_cast<int>(tilted.dot(place.right) > 0.0) +
                             static_cast<int>(tilted.dot(place.down) > 0.0);
        ++invertedAxes[static_cast<std::size_t>(inverted)];
        // With both slopes, or both negatives, one axis is inverted for every h. Otherwise h
        // decides between none and both.
        const double h = Pu.cross(Pv).dot(place.normal);
        const int whereSignsDiffer = signBu * h > 0.0 ? 0 : 2;
        EXPECT_EQ(inverted, signBu == signBv ? 1 : whereSignsDiffer);
    }
    EXPECT_EQ(invertedAxes, (std::array<int, 3>{4, 8, 4}));
}

}  // namespace
}  // namespace raytracer
