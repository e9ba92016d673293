// Coarse rounding of u and v, and differences over the width of a texel of the other axis.
#include <grader/tasks/bump/questions/Fineness.h>
#include <grader/tests/tasks/bump/Asked.h>
#include <grader/tests/tasks/bump/Judging.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>

namespace ticker::tasks::bump {
namespace {

using Steps = std::function<double(double)>;

double exact(double coordinate) {
    return coordinate;
}

Steps inSteps(int count) {
    return [count](double coordinate) { return std::floor(coordinate * count) / count; };
}

/// Forward differences at the rounded place; the tangents are those of the point.
selftest::NormalFunction rounded(const Parametrisation& parametrisation, const Steps& u,
                                 const Steps& v, double strength = 1.0) {
    return [=](const selftest::Point& point) {
        const Vector3 n = (point.position - point.centre).normalised();
        const int width = point.map.width();
        const int height = point.map.height();
        const int c = std::min(static_cast<int>(u(parametrisation.u(n)) * width), width - 1);
        const int r = std::min(static_cast<int>(v(parametrisation.v(n)) * height), height - 1);
        const double here = point.map.at(c, r);
        const double alongU = point.map.at((c + 1) % width, r) - here;
        const double alongV = point.map.at(c, std::min(r + 1, height - 1)) - here;
        return (n - strength *
                        (alongU * parametrisation.alongU(n) + alongV * parametrisation.alongV(n)))
            .normalised();
    };
}

const Parametrisation kUpright({0.0, 1.0, 0.0}, 0.37, false);

Fineness finenessOf(const selftest::NormalFunction& function,
                    const Parametrisation& parametrisation = kUpright, std::uint64_t seed = 4) {
    Questionnaire questionnaire;
    Draws draws(seed);
    const FinenessPlan plan = planFineness(questionnaire, draws, {{0.0, 0.0, 20.0}, 12.0});
    RampJudgement ramps;
    ramps.shape = {1001, 801, 90, 0.5, 2.0};
    ramps.fit = ParametrisationFit{parametrisation};
    ramps.response = Response{};
    ramps.response->u.bandStrength.fill(0.5 / 1000);
    ramps.response->v.bandStrength.fill(0.5 / 800);
    return readFineness(plan, tests::answersOf(questionnaire, function), ramps);
}

// The steps of a table of arc cosines are four times as wide near the poles as in the middle.
TEST(ReadFineness, SeesRowsThatAreCoarseNearThePolesAlone) {
    const Steps table = [](double v) {
        constexpr double kEntries = 256.0;  // for each unit of the cosine
        const double cosine = std::round(std::cos(v * std::numbers::pi) * kEntries) / kEntries;
        return std::acos(std::clamp(cosine, -1.0, 1.0)) / std::numbers::pi;
    };
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Fineness fineness = finenessOf(rounded(kUpright, exact, table), kUpright, seed);
        EXPECT_TRUE(fineness.goodU()) << seed;
        EXPECT_FALSE(fineness.goodV()) << seed;
    }
}

TEST(ReadFineness, SeesThatNeighboursTiltOppositeWays) {
    for (const double strength : {0.05, 1.0, 50.0})
        for (const bool mirrored : {false, true}) {
            const Parametrisation parametrisation({0.0, 1.0, 0.0}, 0.1, mirrored);
            const Fineness fineness =
                finenessOf(rounded(parametrisation, exact, exact, strength), parametrisation);
            EXPECT_GT(fineness.u, 0.99) << strength;
            EXPECT_GT(fineness.v, 0.99) << strength;
        }
}

// Central differences over three texels to either side are 0 on the zigzag, except with clamped
// neighbours at the seam.
TEST(ReadFineness, LeavesOutWhatOnlyTheSeamShows) {
    const selftest::NormalFunction wide = [](const selftest::Point& point) {
        const Vector3 n = (point.position - point.centre).normalised();
        const int width = point.map.width();
        const int height = point.map.height();
        const int c = std::min(static_cast<int>(kUpright.u(n) * width), width - 1);
        const int r = std::min(static_cast<int>(kUpright.v(n) * height), height - 1);
        const double alongU =
            point.map.at(std::min(c + 3, width - 1), r) - point.map.at(std::max(c - 3, 0), r);
        const double alongV =
            point.map.at(c, std::min(r + 3, height - 1)) - point.map.at(c, std::max(r - 3, 0));
        return (n - 0.2 * (alongU * kUpright.alongU(n) + alongV * kUpright.alongV(n))).normalised();
    };
    for (std::uint64_t seed = 0; seed < 200; ++seed)
        EXPECT_TRUE(finenessOf(wide, kUpright, seed).good()) << seed;
}

TEST(ReadFineness, SeesWhoRoundsToWholeDegrees) {
    const Fineness u = finenessOf(rounded(kUpright, inSteps(360), exact));
    EXPECT_LT(u.u, -0.5);
    EXPECT_GT(u.v, 0.99);
    const Fineness v = finenessOf(rounded(kUpright, exact, inSteps(180)));
    EXPECT_GT(v.u, 0.99);
    EXPECT_LT(v.v, -0.5);
    EXPECT_LT(finenessOf(rounded(kUpright, inSteps(100), exact)).u, -0.3) << "percent";
}

TEST(ReadFineness, SaysNothingAboutFinerStepsOtherPolesAndWhatIsSmoothedAway) {
    EXPECT_TRUE(finenessOf(rounded(kUpright, inSteps(1000), inSteps(1000))).good());
    const Parametrisation sideways({1.0, 0.0, 0.0}, 0.1, false);
    EXPECT_EQ(finenessOf(rounded(sideways, inSteps(360), exact), sideways).u, 1.0);
    EXPECT_EQ(finenessOf(rounded(kUpright, inSteps(360), exact, 0.01)).u, 1.0);
}

TEST(JudgeBump, FailsWhoRoundsToWholeDegreesAndSaysSo) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const TaskJudgement judgement =
            tests::judge(rounded(kUpright, inSteps(360), inSteps(180)), seed);
        EXPECT_EQ(judgement.state, TaskState::failed);
        EXPECT_EQ(tests::firstId(judgement), "bump.wrong");
        EXPECT_NE(judgement.reason.find("same texel"), std::string::npos) << judgement.reason;
    }
}

double interpolated(const raytracer::HeightMap& map, double u, double v) {
    const double x = (u - std::floor(u)) * (map.width() - 1);
    const double y = std::clamp(v, 0.0, 1.0) * (map.height() - 1);
    const int c = static_cast<int>(x);
    const int r = std::min(static_cast<int>(y), map.height() - 2);
    const auto alongRow = [&](int row) {
        return std::lerp(map.at(c, row), map.at((c + 1) % map.width(), row), x - c);
    };
    return std::lerp(alongRow(r), alongRow(r + 1), y - r);
}

// One step for both axes, as in `const double eps = 1.0 / width`: many texels along v on a map that
// is much taller than wide, but one or two on any picture.
TEST(JudgeBump, PassesDifferencesOverTheSameShareOfEitherAxis) {
    for (const bool ofWidth : {false, true})
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            const TaskJudgement judgement = tests::judge(
                [&](const selftest::Point& point) {
                    const Vector3 n = (point.position - point.centre).normalised();
                    const double u = kUpright.u(n);
                    const double v = kUpright.v(n);
                    const double e = 1.0 / (ofWidth ? point.map.width() : point.map.height());
                    const auto height = [&](double a, double b) {
                        return interpolated(point.map, a, b);
                    };
                    const double onU = (height(u + e, v) - height(u - e, v)) / (2.0 * e);
                    const double onV = (height(u, v + e) - height(u, v - e)) / (2.0 * e);
                    return (n - 0.01 * (onU * kUpright.alongU(n) + onV * kUpright.alongV(n)))
                        .normalised();
                },
                seed);
            EXPECT_EQ(judgement.state, TaskState::passed) << judgement.reason;
        }
}

}  // namespace
}  // namespace ticker::tasks::bump
