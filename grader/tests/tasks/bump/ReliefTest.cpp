// Reliefs: the pictures of a failing submission, and edges that rise beside edges that fall.
#include <grader/lab/selftest/BumpReadings.h>
#include <grader/tasks/bump/questions/Proportion.h>
#include <grader/tasks/bump/questions/RampLadder.h>
#include <grader/tests/tasks/bump/Asked.h>
#include <grader/tests/tasks/bump/Judging.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace ticker::tests {
namespace {

using selftest::Mistake;
using tasks::bump::StepBalance;

const EvidenceValue* evidence(const TaskJudgement& judgement, const std::string& key) {
    for (const auto& [name, value] : judgement.findings.front().evidence)
        if (name == key) return &value;
    return nullptr;
}

TEST(BumpRelief, ShowsTheHalfInvertedLettersInWordsAndPictures) {
    const TaskJudgement judgement = judge({}, Mistake::invertedU);
    ASSERT_EQ(firstId(judgement), "bump.inverted-u");
    EXPECT_EQ(std::get<std::string>(*evidence(judgement, "letterH")), "half");
    EXPECT_EQ(std::get<std::string>(*evidence(judgement, "letterL")), "half");
    const std::vector<Raster>& rasters = judgement.findings.front().rasters;
    ASSERT_EQ(rasters.size(), 2U);
    for (const Raster& raster : rasters)
        EXPECT_EQ(raster.values.size(), static_cast<std::size_t>(raster.width * raster.height));
}

/// The correlation of two pictures.
double likeness(const std::vector<float>& a, const std::vector<float>& b) {
    double meanA = 0.0;
    double meanB = 0.0;
    const auto count = static_cast<double>(a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        meanA += a[i] / count, meanB += b[i] / count;
    double aa = 0.0;
    double bb = 0.0;
    double ab = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        aa += (a[i] - meanA) * (a[i] - meanA);
        bb += (b[i] - meanB) * (b[i] - meanB);
        ab += (a[i] - meanA) * (b[i] - meanB);
    }
    return ab / std::sqrt(aa * bb);
}

TEST(BumpRelief, RecoversTheReliefThatTheNormalsShow) {
    // Inverted along both axes, so the picture must be the negative of the true one.
    const TaskJudgement inverted = judge({}, Mistake::inverted);
    const std::vector<Raster>& lowered = inverted.findings.front().rasters;
    EXPECT_LT(likeness(lowered.at(0).values, lowered.at(1).values), -0.9);
    EXPECT_EQ(std::get<std::string>(*evidence(inverted, "letterH")), "lowered");
    EXPECT_EQ(std::get<std::string>(*evidence(inverted, "letterL")), "raised");
    // Upside down, but raised.
    const TaskJudgement turned = judge({}, Mistake::upsideDown);
    const std::vector<Raster>& raised = turned.findings.front().rasters;
    EXPECT_GT(likeness(raised.at(0).values, raised.at(1).values), 0.9);
}

StepBalance balanceOf(const selftest::NormalFunction& function, std::uint64_t seed) {
    Questionnaire questionnaire;
    tasks::bump::Draws draws(seed);
    const tasks::bump::Ball ball{{0.0, 0.0, 20.0}, 12.0};
    const auto ladder = planLadder(questionnaire, draws, ball, draws.directions(1000));
    const auto plan = planProportion(questionnaire, draws, ball);
    const Answers answers = answersOf(questionnaire, function);
    const tasks::bump::RampJudgement ramps = judgeLadder(ladder, answers).ramps;
    return ramps.response ? readBalance(plan, answers, ramps) : StepBalance{9.0, 9.0};
}

/// A slope from the difference to the texel before and that to the texel after.
using Choice = double (*)(double before, double after);

double larger(double before, double after) {
    return std::max(before, after);
}

double smaller(double before, double after) {
    return std::min(before, after);
}

double mean(double before, double after) {
    return 0.5 * (before + after);
}

double steeper(double before, double after) {
    return std::abs(before) > std::abs(after) ? before : after;
}

double gentler(double before, double after) {
    return std::abs(before) > std::abs(after) ? after : before;
}

selftest::NormalFunction choosing(Choice onU, Choice onV,
                                  const Parametrisation& parametrisation = kParametrisation) {
    return [=](const Point& point) {
        const Vector3 n = smooth(point);
        const int width = point.map.width();
        const int height = point.map.height();
        const int c = std::min(static_cast<int>(parametrisation.u(n) * width), width - 1);
        const int r = std::min(static_cast<int>(parametrisation.v(n) * height), height - 1);
        const double here = point.map.at(c, r);
        const double alongU = onU(here - point.map.at((c + width - 1) % width, r),
                                  point.map.at((c + 1) % width, r) - here);
        const double alongV = onV(here - point.map.at(c, std::max(r - 1, 0)),
                                  point.map.at(c, std::min(r + 1, height - 1)) - here);
        return (n - alongU * parametrisation.alongU(n) - alongV * parametrisation.alongV(n))
            .normalised();
    };
}

// Chance leaves a standard deviation of 0.055; the seeds are fixed.
TEST(ReadBalance, IsEvenForEveryAcceptedReading) {
    const std::vector<selftest::Reading> readings = selftest::acceptedReadings(1);
    for (std::size_t i = 0; i < readings.size(); i += 7) {
        selftest::Reading reading = readings[i];
        reading.heights = selftest::Reading::Heights::given;  // the others need coarse ramps
        const StepBalance balance = balanceOf(
            [&](const Point& point) { return modelNormal(reading, Mistake::none, point); }, i);
        EXPECT_NEAR(balance.u, 0.0, 0.25) << describe(reading);
        EXPECT_NEAR(balance.v, 0.0, 0.25) << describe(reading);
    }
}

TEST(ReadBalance, SaysWhetherRisesOrFallsAreLeft) {
    for (const bool mirrored : {false, true}) {
        const Parametrisation parametrisation({0.0, 1.0, 0.0}, 0.1, mirrored);
        const StepBalance both = balanceOf(choosing(larger, smaller, parametrisation), 7);
        EXPECT_NEAR(both.u, 0.88, 0.06);
        EXPECT_NEAR(both.v, -0.88, 0.06);
        const StepBalance one = balanceOf(choosing(mean, larger, parametrisation), 8);
        EXPECT_NEAR(one.u, 0.0, 0.25);
        EXPECT_NEAR(one.v, 0.88, 0.06);
    }
    EXPECT_TRUE((StepBalance{0.39, -0.39}.good()));
    EXPECT_FALSE((StepBalance{0.41, 0.0}.goodU()));
    EXPECT_FALSE((StepBalance{0.0, -0.41}.goodV()));
}

TEST(ReadBalance, IsEvenForASmoothSphere) {
    Questionnaire questionnaire;
    tasks::bump::Draws draws(4);
    const auto plan = planProportion(questionnaire, draws, {{0.0, 0.0, 20.0}, 12.0});
    tasks::bump::RampJudgement ramps;
    ramps.fit = tasks::bump::ParametrisationFit{kParametrisation};
    ramps.response = tasks::bump::Response{};
    const StepBalance balance = readBalance(plan, answersOf(questionnaire, smooth), ramps);
    EXPECT_EQ(balance.u, 0.0);
    EXPECT_EQ(balance.v, 0.0);
}

struct LosesEdges {
    Choice onU;
    Choice onV;
    std::string words;
};

TEST(JudgeBump, FailsWhoseSlopesAreLostAtFallsOrAtRises) {
    const std::vector<LosesEdges> readings{
        {larger, larger, "that fall along u and v leave"},
        {larger, mean, "that fall along u leave"},
        {mean, larger, "that fall along v leave"},
        {smaller, smaller, "that rise along u and v leave"},
        {smaller, mean, "that rise along u leave"},
        {mean, smaller, "that rise along v leave"},
        {larger, smaller, "that fall along u and those that rise along v leave"}};
    for (const std::uint64_t seed : {1U, 2U, 3U})
        for (const auto& [onU, onV, words] : readings) {
            const TaskJudgement judgement = judge(choosing(onU, onV), seed);
            EXPECT_EQ(judgement.state, TaskState::failed) << words;
            EXPECT_EQ(firstId(judgement), "bump.wrong");
            EXPECT_NE(judgement.reason.find(words), std::string::npos) << judgement.reason;
        }
}

// The steeper difference keeps every edge. Neither of the two favours rises or falls.
TEST(JudgeBump, StillPassesTheSteeperAndTheGentlerOfTwoDifferences) {
    for (const Choice choice : {steeper, gentler})
        EXPECT_EQ(judge(choosing(choice, choice)).state, TaskState::passed);
}

}  // namespace
}  // namespace ticker::tests
