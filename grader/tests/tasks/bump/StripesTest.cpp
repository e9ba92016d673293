// Interpolations that must not depend on the other axis, on submissions made by hand.
#include <grader/lab/selftest/BumpReadings.h>
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

using tasks::bump::StripeAgreement;

StripeAgreement stripesOf(const selftest::NormalFunction& function, std::uint64_t seed) {
    Questionnaire questionnaire;
    tasks::bump::Draws draws(seed);
    const tasks::bump::Ball ball{{0.0, 0.0, 20.0}, 12.0};
    const auto ladder = planLadder(questionnaire, draws, ball, draws.directions(400));
    const auto stripes = planStripes(questionnaire, draws, ball);
    const Answers answers = answersOf(questionnaire, function);
    const tasks::bump::RampJudgement ramps = judgeLadder(ladder, answers).ramps;
    if (!ramps.response) return {};
    return readStripes(stripes, answers, ramps);
}

/// Maps the fractions of a point's column and row to those that the code uses.
using Fractions = std::pair<double, double> (*)(double column, double row);

/// The height at a place in texels, interpolated between the middles of four texels.
double heightAt(const selftest::HeightMap& map, double x, double y, Fractions fractions) {
    const auto [fx, fy] = fractions(x - std::floor(x), y - std::floor(y));
    const auto texel = [&map](double c, double r) {
        const int column = (static_cast<int>(c) + map.width()) % map.width();
        return map.at(column, std::clamp(static_cast<int>(r), 0, map.height() - 1));
    };
    const double c = std::floor(x);
    const double r = std::floor(y);
    return (1.0 - fy) * ((1.0 - fx) * texel(c, r) + fx * texel(c + 1.0, r)) +
           fy * ((1.0 - fx) * texel(c, r + 1.0) + fx * texel(c + 1.0, r + 1.0));
}

/// Forward differences.
selftest::NormalFunction bilinear(Fractions fractions) {
    return [fractions](const Point& point) {
        const Vector3 n = smooth(point);
        const double x = kParametrisation.u(n) * point.map.width() - 0.5;
        const double y = kParametrisation.v(n) * point.map.height() - 0.5;
        const double here = heightAt(point.map, x, y, fractions);
        const double onU = heightAt(point.map, x + 1.0, y, fractions) - here;
        const double onV = heightAt(point.map, x, y + 1.0, fractions) - here;
        return (n - onU * kParametrisation.alongU(n) - onV * kParametrisation.alongV(n))
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

TEST(ReadStripes, AgreeForAcceptedReadings) {
    constexpr std::size_t kStep = 7;
    const std::vector<selftest::Reading> readings = selftest::acceptedReadings(1);
    for (std::size_t i = 0; i < readings.size(); i += kStep) {
        const StripeAgreement stripes = stripesOf(
            [&](const Point& point) {
                return modelNormal(readings[i], selftest::Mistake::none, point);
            },
            i);
        EXPECT_NEAR(stripes.u, 1.0, 0.01) << describe(readings[i]);
        EXPECT_NEAR(stripes.v, 1.0, 0.01) << describe(readings[i]);
    }
}

TEST(ReadStripes, AgreeForASmoothSphere) {
    EXPECT_TRUE(stripesOf(smooth, 4).good());
}

TEST(ReadStripes, TellWhichFractionIsWrong) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const StripeAgreement right = stripesOf(bilinear(ownFractions), seed);
        EXPECT_GT(std::min(right.u, right.v), 0.999);
        const StripeAgreement column = stripesOf(bilinear(columnTwice), seed);
        EXPECT_TRUE(column.goodU()) << column.u;
        EXPECT_FALSE(column.goodV()) << column.v;
        const StripeAgreement row = stripesOf(bilinear(rowTwice), seed);
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

TEST(JudgeBump, SaysWhichFractionWeighsTheWrongAxis) {
    expectWords(bilinear(columnTwice), "the fraction of the column for that of the row",
                "Each axis has a fraction of its own");
    expectWords(bilinear(rowTwice), "the fraction of the row for that of the column",
                "Each axis has a fraction of its own");
    EXPECT_EQ(judge(bilinear(ownFractions)).state, TaskState::passed);
}

}  // namespace
}  // namespace ticker::tests
