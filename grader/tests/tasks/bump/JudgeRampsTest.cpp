// Judgements of ramps, for tilts and submissions made by hand.
#include <grader/tasks/bump/questions/RampLadder.h>
#include <grader/tests/tasks/bump/Asked.h>
#include <grader/tests/tasks/bump/Spread.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace ticker::tasks::bump {
namespace {

/// The tilts at one place: `onU` and `onV` along the slope of either ramp, `acrossU` and `acrossV`
/// along the other axis. `bowU` and `bowV` are the bows' tilts as multiples of their ramps'.
struct Tilts {
    double onU = 1.0;
    double onV = 1.0;
    double bowU;
    double bowV;
    double acrossU = 0.0;
    double acrossV = 0.0;
};

RampJudgement judge(const std::function<void(double u, double v, Tilts&)>& change) {
    std::vector<RampTilts> all;
    for (const Vector3& n : tests::spread(900)) {
        const double u = tests::kParametrisation.u(n);
        const double v = tests::kParametrisation.v(n);
        Tilts at{.bowU = 1.0 - 2.0 * u, .bowV = 1.0 - 2.0 * v};
        change(u, v, at);
        const Vector3 onU = -at.onU * tests::kParametrisation.alongU(n) -
                            at.acrossU * tests::kParametrisation.alongV(n);
        const Vector3 onV = -at.onV * tests::kParametrisation.alongV(n) -
                            at.acrossV * tests::kParametrisation.alongU(n);
        all.push_back({n, onU, onU * at.bowU, onV, onV * at.bowV});
    }
    return judgeRamps({}, all);
}

void right(double, double, Tilts&) {}

TEST(JudgeRamps, FindTheParametrisationAndTheSenses) {
    const RampJudgement judgement = judge(right);
    EXPECT_EQ(judgement.kind, RampKind::right);
    ASSERT_TRUE(judgement.fit);
    EXPECT_NEAR(judgement.fit->axisLength, 1.0, 1e-6);
    EXPECT_NEAR(judgement.fit->medianUError, 0.0, 1e-6);
    EXPECT_NEAR(judgement.fit->medianVError, 0.0, 1e-6);
    EXPECT_EQ(judgement.fit->strayShare, 0.0);
    EXPECT_NEAR(judgement.fit->parametrisation.axis().y, 1.0, 1e-6);
    EXPECT_NEAR(judgement.strength.alongU, 1.0, 1e-9);
    EXPECT_FALSE(judgement.transposed);
    EXPECT_EQ(judge([](double, double, Tilts& t) { t.onU = -1.0; }).kind, RampKind::invertedU);
    EXPECT_EQ(judge([](double, double, Tilts& t) { t.onV = -1.0; }).kind, RampKind::invertedV);
    EXPECT_EQ(judge([](double, double, Tilts& t) { t.onU = t.onV = -1.0; }).kind,
              RampKind::inverted);
}

TEST(JudgeRamps, KnowAxesThatAreExchangedOrLeanElsewhere) {
    EXPECT_EQ(judge([](double, double, Tilts& t) {
                  t.onU = t.onV = 0.0;
                  t.acrossU = t.acrossV = 1.0;
              }).kind,
              RampKind::swapped);
    EXPECT_EQ(judge([](double, double, Tilts& t) {
                  t.onU = 0.0;
                  t.acrossU = 1.0;
              }).kind,
              RampKind::strangeDirection)
        << "one axis alone";
    EXPECT_EQ(judge([](double, double v, Tilts& t) { t.acrossU = v < 0.5 ? 0.8 : -0.7; }).kind,
              RampKind::strangeDirection);
    EXPECT_EQ(judge([](double u, double, Tilts& t) { t.onV = u < 0.5 ? 1.0 : -1.0; }).kind,
              RampKind::longitudeDependent);
}

TEST(JudgeRamps, KnowSilenceAndAxesThatAreIgnored) {
    const auto strengths = [](double onU, double onV) {
        return judge([=](double, double, Tilts& t) {
                   t.onU = onU;
                   t.onV = onV;
               })
            .kind;
    };
    EXPECT_EQ(strengths(0.0, 0.0), RampKind::silent);
    EXPECT_EQ(strengths(0.9e-13, 0.9e-13), RampKind::silent);
    EXPECT_EQ(strengths(1.1e-13, 1.1e-13), RampKind::right);
    EXPECT_EQ(strengths(0.9e-4, 1.0), RampKind::slopeUIgnored);
    EXPECT_EQ(strengths(1.0, 0.9e-4), RampKind::slopeVIgnored);
    EXPECT_EQ(strengths(1.2e-4, 1.0), RampKind::right);
    EXPECT_EQ(strengths(1.0, 1.2e-4), RampKind::right);
    const auto someTilt = [](double share) {
        return judge([=](double u, double, Tilts& t) { t.onU = u < share ? 1.0 : 0.0; }).kind;
    };
    EXPECT_EQ(someTilt(0.04), RampKind::slopeUIgnored) << "hardly a point";
    EXPECT_NE(someTilt(0.06), RampKind::slopeUIgnored);
}

TEST(JudgeRamps, KnowPointsThatAreNotTilted) {
    const auto dead = [](double share, double sense) {
        return judge([=](double u, double v, Tilts& t) {
                   t.onV = std::fmod(u * 7.0 + v * 13.0, 1.0) < share ? 0.0 : sense;
               })
            .kind;
    };
    EXPECT_EQ(dead(0.04, 1.0), RampKind::patchy);
    EXPECT_EQ(dead(0.004, 1.0), RampKind::right);
    EXPECT_EQ(dead(0.04, -1.0), RampKind::strangeDirection);
}

TEST(JudgeRamps, KnowPlacesThatNoPolarCoordinatesGive) {
    const RampJudgement transposed = judge([](double u, double v, Tilts& t) {
        t.bowU = 1.0 - 2.0 * v;
        t.bowV = 1.0 - 2.0 * u;
    });
    EXPECT_EQ(transposed.kind, RampKind::swapped);
    EXPECT_TRUE(transposed.transposed);
    EXPECT_FALSE(transposed.response);
    EXPECT_EQ(judge([](double, double, Tilts& t) { t.bowU = std::abs(t.bowU); }).kind,
              RampKind::signLost);
    EXPECT_EQ(judge([](double, double, Tilts& t) { t.bowV = std::abs(t.bowV); }).kind,
              RampKind::signLost);
    EXPECT_EQ(judge([](double u, double, Tilts& t) {
                  t.bowV = 1.0 - 2.0 * std::fmod(5.0 * u, 1.0);
              }).kind,
              RampKind::strangeParametrisation);
    const auto opposite = [](double share) {
        return judge([=](double u, double, Tilts& t) {
                   t.bowV = std::fmod(5.0 * u, 1.0) < share ? -0.5 : 0.5;
               })
            .kind;
    };
    EXPECT_EQ(opposite(0.08), RampKind::signLost);
    EXPECT_EQ(opposite(0.12), RampKind::strangeParametrisation);
}

/// A submission that tilts by `tilted(slope, isU)` along each axis.
LadderJudgement judgeSubmission(const std::function<double(double, bool isU)>& tilted) {
    Questionnaire questionnaire;
    Draws draws(6);
    const Ball ball{{0.0, 0.0, 25.0}, 15.0};
    const RampLadder ladder = planLadder(questionnaire, draws, ball, tests::spread(400));
    const Answers answers = tests::answersOf(
        questionnaire, tests::inProportion(tests::kParametrisation, [&](const tests::Place& at,
                                                                        const selftest::Point&) {
            const auto times = [&](double slope, bool isU) {
                return slope == 0.0 ? 0.0 : tilted(slope, isU) / slope;
            };
            return std::pair(times(at.alongU, true), times(at.alongV, false));
        }));
    return judgeLadder(ladder, answers);
}

TEST(JudgeLadder, TakesGentleRampsWhereTheyTiltClearly) {
    const LadderJudgement clear = judgeSubmission([](double slope, bool) { return 100.0 * slope; });
    EXPECT_EQ(clear.ramps.kind, RampKind::right);
    EXPECT_EQ(clear.ramps.shape.rise, 0.1);
    EXPECT_TRUE(clear.growsWithSlope);
    EXPECT_GT(clear.steepAgrees, 0.98);
    EXPECT_LT(clear.flatTilt, 1e-9);
    const LadderJudgement faint = judgeSubmission([](double slope, bool) { return slope; });
    EXPECT_EQ(faint.ramps.kind, RampKind::right);
    EXPECT_EQ(faint.ramps.shape.rise, 1.0) << "gentle ones tilt by a ten-thousandth";
    const LadderJudgement fainter =
        judgeSubmission([](double slope, bool) { return 2e-3 * slope; });
    EXPECT_EQ(fainter.ramps.shape.rise, 5.0) << "and moderate ones by less than a millionth";
}

TEST(JudgeLadder, SeesTiltsThatDoNotGrowOrTurn) {
    const auto even = judgeSubmission([](double slope, bool) { return std::copysign(0.1, slope); });
    EXPECT_FALSE(even.growsWithSlope);
    EXPECT_GT(even.steepAgrees, 0.98);
    const auto turning = judgeSubmission([](double slope, bool isU) {
        return 100.0 * (isU && std::abs(slope) > 1e-3 ? -slope : slope);
    });
    EXPECT_NEAR(turning.steepAgrees, 0.5, 0.02) << "one axis of two";
}

}  // namespace
}  // namespace ticker::tasks::bump
