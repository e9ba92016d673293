// Slopes and interpolations that must not depend on the other axis, on submissions made by hand.
#include <grader/lab/selftest/BumpReadings.h>
#include <grader/tasks/bump/questions/Proportion.h>
#include <grader/tasks/bump/questions/RampLadder.h>
#include <grader/tasks/bump/questions/Stripes.h>
#include <grader/tests/tasks/bump/Asked.h>
#include <grader/tests/tasks/bump/Judging.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace ticker::tests {
namespace {

using tasks::bump::AxisIndependence;
using tasks::bump::StripeAgreement;

struct Both {
    AxisIndependence independence;
    StripeAgreement stripes;
};

Both bothOf(const selftest::NormalFunction& function, std::uint64_t seed) {
    Questionnaire questionnaire;
    tasks::bump::Draws draws(seed);
    const tasks::bump::Ball ball{{0.0, 0.0, 20.0}, 12.0};
    const auto ladder = planLadder(questionnaire, draws, ball, draws.directions(400));
    const auto proportion = planProportion(questionnaire, draws, ball);
    const auto stripes = planStripes(questionnaire, draws, ball);
    const Answers answers = answersOf(questionnaire, function);
    const tasks::bump::RampJudgement ramps = judgeLadder(ladder, answers).ramps;
    if (!ramps.response) return {};
    return {readIndependence(proportion, answers, ramps), readStripes(stripes, answers, ramps)};
}

/// Factors of the tilts along u and along v, from both slopes in heights per texel.
using Coupling = std::pair<double, double> (*)(double onU, double onV);

selftest::NormalFunction coupled(Coupling coupling) {
    return inProportion(kParametrisation, [coupling](const Place& at, const Point&) {
        return coupling(at.alongU, at.alongV);
    });
}

std::pair<double, double> normalisedAfterU(double onU, double /*onV*/) {
    return {1.0, std::hypot(1.0, onU)};
}

std::pair<double, double> normalisedAfterV(double /*onU*/, double onV) {
    return {std::hypot(1.0, onV), 1.0};
}

/// Each axis by itself: the arctangent of its slope.
std::pair<double, double> bentAlone(double onU, double onV) {
    const auto factor = [](double slope) { return slope == 0.0 ? 1.0 : std::atan(slope) / slope; };
    return {factor(onU), factor(onV)};
}

/// Forward differences of heights that are interpolated between the middles of texels.
/// `fractions` gives those of the column and the row that are used from those of the point.
using Fractions = std::pair<double, double> (*)(double column, double row);

selftest::NormalFunction bilinear(Fractions fractions) {
    return [fractions](const Point& point) {
        const Vector3 n = smooth(point);
        const selftest::HeightMap& map = point.map;
        const auto height = [&](double x, double y) {
            const auto [fx, fy] = fractions(x - std::floor(x), y - std::floor(y));
            const auto texel = [&](double c, double r) {
                const int column = (static_cast<int>(c) + map.width()) % map.width();
                return map.at(column, std::clamp(static_cast<int>(r), 0, map.height() - 1));
            };
            const double c = std::floor(x);
            const double r = std::floor(y);
            return (1.0 - fy) * ((1.0 - fx) * texel(c, r) + fx * texel(c + 1.0, r)) +
                   fy * ((1.0 - fx) * texel(c, r + 1.0) + fx * texel(c + 1.0, r + 1.0));
        };
        const double x = kParametrisation.u(n) * map.width() - 0.5;
        const double y = kParametrisation.v(n) * map.height() - 0.5;
        const double here = height(x, y);
        return (n - (height(x + 1.0, y) - here) * kParametrisation.alongU(n) -
                (height(x, y + 1.0) - here) * kParametrisation.alongV(n))
            .normalised();
    };
}

std::pair<double, double> ownFractions(double column, double row) {
    return {column, row};
}

std::pair<double, double> columnTwice(double column, double /*row*/) {
    return {column, column};
}

std::pair<double, double> rowTwice(double /*column*/, double row) {
    return {row, row};
}

TEST(ReadIndependence, IsGoodForAcceptedReadings) {
    constexpr std::size_t kStep = 7;
    const std::vector<selftest::Reading> readings = selftest::acceptedReadings(1);
    for (std::size_t i = 0; i < readings.size(); i += kStep) {
        const Both both = bothOf(
            [&](const Point& point) {
                return modelNormal(readings[i], selftest::Mistake::none, point);
            },
            i);
        EXPECT_NEAR(both.independence.u, 1.0, 0.12) << describe(readings[i]);
        EXPECT_NEAR(both.independence.v, 1.0, 0.12) << describe(readings[i]);
        EXPECT_NEAR(both.stripes.u, 1.0, 0.01) << describe(readings[i]);
        EXPECT_NEAR(both.stripes.v, 1.0, 0.01) << describe(readings[i]);
    }
}

TEST(ReadIndependence, SeesAnAxisThatCountsByTheOther) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const AxisIndependence afterU = bothOf(coupled(normalisedAfterU), seed).independence;
        EXPECT_FALSE(afterU.goodV()) << afterU.v;
        EXPECT_NEAR(afterU.u, 1.0, 1e-3);
        const AxisIndependence afterV = bothOf(coupled(normalisedAfterV), seed).independence;
        EXPECT_FALSE(afterV.goodU()) << afterV.u;
        EXPECT_NEAR(afterV.v, 1.0, 1e-3);
    }
}

TEST(ReadIndependence, LeavesEachAxisItsOwnCurve) {
    const AxisIndependence bent = bothOf(coupled(bentAlone), 3).independence;
    EXPECT_NEAR(bent.u, 1.0, 0.02);
    EXPECT_NEAR(bent.v, 1.0, 0.02);
}

TEST(ReadIndependence, AllowsWhatAcceptedReadingsGive) {
    EXPECT_TRUE((AxisIndependence{0.62, 1.38}.good()));
    EXPECT_FALSE((AxisIndependence{0.58, 1.0}.goodU()));
    EXPECT_FALSE((AxisIndependence{1.0, 1.42}.goodV()));
}

TEST(ReadIndependence, LeavesSmoothSpheresToOthers) {
    EXPECT_TRUE(bothOf(smooth, 4).independence.good());
    EXPECT_TRUE(bothOf(smooth, 4).stripes.good());
}

TEST(ReadStripes, TellWhichFractionIsWrong) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const StripeAgreement right = bothOf(bilinear(ownFractions), seed).stripes;
        EXPECT_GT(std::min(right.u, right.v), 0.999);
        const StripeAgreement column = bothOf(bilinear(columnTwice), seed).stripes;
        EXPECT_TRUE(column.goodU()) << column.u;
        EXPECT_FALSE(column.goodV()) << column.v;
        const StripeAgreement row = bothOf(bilinear(rowTwice), seed).stripes;
        EXPECT_FALSE(row.goodU()) << row.u;
        EXPECT_TRUE(row.goodV()) << row.v;
    }
}

void expectWords(const selftest::NormalFunction& function, const std::string& message,
                 const std::string& hint) {
    const TaskJudgement judgement = judge(function);
    ASSERT_EQ(firstId(judgement), "bump.wrong");
    EXPECT_NE(judgement.reason.find(message), std::string::npos) << judgement.reason;
    EXPECT_NE(judgement.findings.front().hint.find(hint), std::string::npos);
}

TEST(JudgeBump, SaysThatAnAxisDependsOnTheOther) {
    expectWords(coupled(normalisedAfterU), "the tilt along v depends on the slope along u",
                "Normalise once, at the end");
    expectWords(coupled(normalisedAfterV), "the tilt along u depends on the slope along v",
                "Normalise once, at the end");
}

TEST(JudgeBump, SaysWhichFractionWeighsTheWrongAxis) {
    expectWords(bilinear(columnTwice), "the fraction of the column for that of the row",
                "Each axis has a fraction of its own");
    expectWords(bilinear(rowTwice), "the fraction of the row for that of the column",
                "Each axis has a fraction of its own");
    EXPECT_EQ(judge(bilinear(ownFractions)).state, TaskState::passed);
}

}  // namespace
}  // namespace ticker::tests
