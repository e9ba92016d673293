// The pure functions of the judgement, one by one.
#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/answers/Poisson.h>
#include <grader/tasks/bump/answers/Response.h>
#include <grader/tasks/bump/questions/Tilt.h>
#include <grader/tests/tasks/bump/Asked.h>
#include <grader/tests/tasks/bump/Spread.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace ticker::tasks::bump {
namespace {

// 45,000 units in the last place of a number just above 1.
constexpr double kRounding = 1e-11;

using tests::spread;

std::vector<Sighting> seenThrough(const Parametrisation& parametrisation) {
    std::vector<Sighting> seen;
    for (const Vector3& n : spread(400))
        seen.push_back({n, parametrisation.u(n), parametrisation.v(n)});
    return seen;
}

TEST(TiltOf, UndoesTheNormalisationWhateverTheStrength) {
    const Vector3 n = Vector3{0.3, -0.5, 0.8}.normalised();
    const Vector3 tangent = n.cross({0.0, 1.0, 0.0}).normalised();
    for (const double strength : {1e-6, 0.2, 20.0, 1e4}) {
        const Vector3 tilt = tiltOf((n + strength * tangent).normalised(), n);
        EXPECT_NEAR(tilt.dot(tangent) / strength, 1.0, 1e-9 * std::max(1.0, 1.0 / strength));
    }
}

TEST(Parametrisation, RunsToTheRightAndDownwardsOnTheNearSide) {
    const Parametrisation parametrisation({0.0, 1.0, 0.0}, 0.5, false);
    const Vector3 nearest{0.0, 0.0, -1.0};
    EXPECT_NEAR(parametrisation.u(nearest), 0.5, kRounding);
    EXPECT_NEAR(parametrisation.v(nearest), 0.5, kRounding);
    EXPECT_NEAR(parametrisation.alongU(nearest).x, 1.0, kRounding);
    EXPECT_NEAR(parametrisation.alongV(nearest).y, -1.0, kRounding);
}

TEST(Parametrisation, FindsThePointOfEveryTexelAgain) {
    for (const bool mirrored : {false, true})
        for (const Vector3& axis : {Vector3{0, 1, 0}, Vector3{0, 0, -1}, Vector3{1, 0, 0}}) {
            const Parametrisation parametrisation(axis, 0.3, mirrored);
            const Vector3 direction = parametrisation.direction(0.7, 0.2);
            EXPECT_NEAR(parametrisation.u(direction), 0.7, kRounding);
            EXPECT_NEAR(parametrisation.v(direction), 0.2, kRounding);
        }
}

TEST(FitParametrisation, FindsAxisOriginAndMirrorAgain) {
    for (const bool mirrored : {false, true})
        for (const Vector3& axis :
             {Vector3{0, 1, 0}, Vector3{0, -1, 0}, Vector3{0, 0, 1}, Vector3{0.6, 0.0, 0.8}}) {
            const auto fit = fitParametrisation(seenThrough(Parametrisation(axis, 0.83, mirrored)));
            ASSERT_TRUE(fit.has_value());
            EXPECT_TRUE(fit->good());
            EXPECT_EQ(fit->parametrisation.mirrored(), mirrored);
            EXPECT_NEAR(fit->parametrisation.axis().dot(axis), 1.0, 1e-6);
            EXPECT_NEAR(turnDistance(fit->parametrisation.uOffset(), 0.83), 0.0, 1e-6);
        }
}

TEST(FitParametrisation, IsNotMovedByAFewStrayPoints) {
    std::vector<Sighting> seen = seenThrough(Parametrisation({0.0, 1.0, 0.0}, 0.25, false));
    for (std::size_t i = 0; i < seen.size(); i += 50)
        seen[i].u = seen[i].v = 0.5;
    const auto fit = fitParametrisation(seen);
    ASSERT_TRUE(fit.has_value());
    EXPECT_TRUE(fit->good());
    EXPECT_GT(fit->strayShare, 0.0);
}

TEST(FitParametrisation, RefusesRowsThatFollowTheHeight) {
    std::vector<Sighting> seen;
    for (const Vector3& n : spread(400))
        seen.push_back({n, Parametrisation({0.0, 1.0, 0.0}, 0.0, false).u(n), 0.5 - 0.5 * n.y});
    const auto fit = fitParametrisation(seen);
    EXPECT_FALSE(fit.has_value() && fit->good());
}

TEST(FitParametrisation, SaysNothingWhereTooFewPointsTell) {
    std::vector<Sighting> seen = seenThrough(Parametrisation({0.0, 1.0, 0.0}, 0.0, false));
    for (std::size_t i = 40; i < seen.size(); ++i)
        seen[i].v = std::nan("");
    EXPECT_FALSE(fitParametrisation(seen).has_value());
}

TEST(Integrate, GivesBackTheHeightsOfAnEvenField) {
    GridDifferences differences{12, 9, std::vector<double>(108, 0.0),
                                std::vector<double>(108, 0.0)};
    std::vector<double> heights;
    for (int row = 0; row < 9; ++row)
        for (int column = 0; column < 12; ++column)
            heights.push_back(std::sin(0.7 * column) * std::cos(0.4 * row) + 0.1 * column);
    double mean = 0.0;
    for (const double height : heights)
        mean += height / 108.0;
    for (std::size_t i = 0; i < 108; ++i) {
        if (i % 12 != 11) differences.right[i] = heights[i + 1] - heights[i];
        if (i / 12 != 8) differences.down[i] = heights[i + 12] - heights[i];
    }
    const std::vector<double> found = integrate(differences);
    for (std::size_t i = 0; i < 108; ++i)
        EXPECT_NEAR(found[i], heights[i] - mean, 1e-10);
}

/// Tilts along the tangents of other longitudes.
template <typename OtherU>
Response withTangentsAt(const OtherU& otherU) {
    const Parametrisation& parametrisation = tests::kParametrisation;
    std::vector<RampTilts> tilts;
    for (const Vector3& n : tests::spread(800)) {
        const double u = otherU(parametrisation.u(n));
        const Vector3 there = parametrisation.direction(u - std::floor(u), parametrisation.v(n));
        tilts.push_back(
            {n, -parametrisation.alongU(there), {}, -parametrisation.alongV(there), {}});
    }
    return measureResponse(tilts, parametrisation);
}

TEST(TangentsInDegrees, AreThoseOfALongitudeThatGrowsFiftySevenTimesAsFast) {
    constexpr double kDegreesInOne = 180.0 / std::numbers::pi;
    for (const double start : {0.5, 0.0, 0.25}) {
        const Response response =
            withTangentsAt([=](double u) { return start + (u - start) * kDegreesInOne; });
        EXPECT_TRUE(response.tangentsInDegrees) << start;
        EXPECT_EQ(response.tangentTurn, 0.0) << start;
    }
}

TEST(TangentsInDegrees, AreToldFromATurnAndFromAnotherFactor) {
    const Response turned = withTangentsAt([](double u) { return u + 0.25; });
    EXPECT_NEAR(turned.tangentTurn, 90.0, 10.0);
    EXPECT_FALSE(turned.tangentsInDegrees);
    const Response faster = withTangentsAt([](double u) { return 31.0 * u; });
    EXPECT_EQ(faster.tangentTurn, 0.0);
    EXPECT_FALSE(faster.tangentsInDegrees);
}

}  // namespace
}  // namespace ticker::tasks::bump
