// The handout's own test, letters H and L, by hand.
#include <grader/tasks/bump/answers/Letters.h>
#include <grader/tasks/bump/questions/LetterMap.h>
#include <grader/tests/tasks/bump/Asked.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ticker::tasks::bump {
namespace {

using tests::Place;

TEST(LetterMap, HasTwoRowsOfEightLettersByTurns) {
    EXPECT_EQ(letterAt(0, 79), Letter::none);
    EXPECT_EQ(letterAt(0, 80), Letter::h);
    EXPECT_EQ(letterAt(79, 159), Letter::h);
    EXPECT_EQ(letterAt(80, 80), Letter::l);
    EXPECT_EQ(letterAt(0, 160), Letter::l);
    EXPECT_EQ(letterAt(80, 239), Letter::h);
    EXPECT_EQ(letterAt(0, 240), Letter::none);
    EXPECT_EQ(letterAt(639, 100), Letter::l);
}

TEST(LetterMap, RaisesTheStrokesOfAnHAndLowersThoseOfAnL) {
    EXPECT_EQ(letterHeight(20, 120), 1.0) << "left stroke";
    EXPECT_EQ(letterHeight(58, 120), 1.0) << "right stroke";
    EXPECT_EQ(letterHeight(40, 120), 1.0) << "bar";
    EXPECT_EQ(letterHeight(40, 100), 0.0) << "above the bar";
    EXPECT_EQ(letterHeight(40, 140), 0.0) << "below it";
    EXPECT_EQ(letterHeight(5, 120), 0.0);
    EXPECT_EQ(letterHeight(80 + 25, 120), -1.0) << "the L's stroke";
    EXPECT_EQ(letterHeight(80 + 50, 142), -1.0) << "its foot";
    EXPECT_EQ(letterHeight(80 + 50, 120), 0.0) << "beside it";
    EXPECT_EQ(letterHeight(20, 40), 0.0) << "no letter";
    // An even slope of six texels; its middle is the stroke's edge at 14.
    for (int column = 11; column <= 16; ++column)
        EXPECT_NEAR(letterHeight(column, 120), 0.5 + (column + 0.5 - 14.0) / 6.0, 1e-12);
    EXPECT_NEAR(letterHeight(20, 90), 0.5 + 0.5 / 6.0, 1e-12) << "the upper edge, at 10";
    EXPECT_NEAR(letterHeight(20, 149), 0.5 + 0.5 / 6.0, 1e-12) << "the lower one, at 70";
}

TEST(LetterMap, IsGreyBetween) {
    const probe::HeightMapDescription map = letterMap();
    const auto at = [&](int column, int row) {
        return static_cast<int>(map.bytes.at(static_cast<std::size_t>(row * 640 + column)));
    };
    EXPECT_EQ(map.bytes.size(), 640U * 320U);
    EXPECT_EQ(at(5, 5), 128);
    EXPECT_EQ(at(20, 120), 208);
    EXPECT_EQ(at(105, 120), 48);
    EXPECT_EQ(at(639, 319), 128);
}

/// The letter whose stroke is at the place.
Letter letterOf(const Place& at) {
    return letterAt(at.column, at.row);
}

using Times = std::function<std::pair<double, double>(const Place&)>;

/// Questions, answers and a response of equal strength everywhere.
struct AskedLetters {
    Questionnaire questionnaire;
    LetterPlan plan;
    Answers answers;
    Response response;

    explicit AskedLetters(const Times& times)
        : plan(planned(questionnaire)),
          answers(tests::answersOf(
              questionnaire, tests::inProportion(tests::kParametrisation,
                                                 [times](const Place& at, const selftest::Point&) {
                                                     return times(at);
                                                 }))) {
        response.u.bandStrength.fill(1.0);
        response.v.bandStrength.fill(2.0);
    }
    static LetterPlan planned(Questionnaire& questionnaire) {
        Draws draws(3);
        return planLetters(questionnaire, draws);
    }
    [[nodiscard]] LetterReading read() const {
        return readLetters(plan, answers, tests::kParametrisation, response);
    }
};

std::pair<double, double> rightTimes(const Place&) {
    return {1.0, 1.0};
}

TEST(PlanLetters, AsksOnAGridOverTheNearSide) {
    Questionnaire questionnaire;
    const LetterPlan plan = AskedLetters::planned(questionnaire);
    ASSERT_EQ(plan.directions.size(), 128U * 64U);
    const auto longitude = [](const Vector3& n) { return std::atan2(n.x, -n.z); };
    const Vector3& first = plan.directions.front();
    const Vector3& last = plan.directions.back();
    EXPECT_NEAR(longitude(first), -0.49 * std::numbers::pi, 0.02);
    EXPECT_NEAR(longitude(last), 0.49 * std::numbers::pi, 0.02);
    EXPECT_NEAR(longitude(first), -longitude(last), 1e-9);
    EXPECT_NEAR(std::asin(first.y), 0.245 * std::numbers::pi, 0.015);
    EXPECT_NEAR(first.y, -last.y, 1e-9);
    EXPECT_NEAR(first.magnitude(), 1.0, 1e-12);
    EXPECT_NEAR(plan.directions[127].y, first.y, 1e-12) << "row after row";
}

void expectAll(const EdgeCount& edges, int EdgeCount::*kind, int least, int most) {
    EXPECT_EQ(edges.*kind, edges.crossed());
    EXPECT_GE(edges.crossed(), least);
    EXPECT_LE(edges.crossed(), most);
}

// Four letters of each kind: an H has four upright edges, except at its bar; an L has two and one
// at its foot.
TEST(ReadLetters, FindsEveryEdgeOfARightReading) {
    const LetterReading reading = AskedLetters(rightTimes).read();
    expectAll(reading.h.alongU, &EdgeCount::right, 265, 295);
    expectAll(reading.h.alongV, &EdgeCount::right, 143, 161);
    expectAll(reading.l.alongU, &EdgeCount::right, 165, 183);
    expectAll(reading.l.alongV, &EdgeCount::right, 117, 131);
    EXPECT_TRUE(reading.good());
}

TEST(ReadLetters, TellsTheAxisAndTheLetterThatAreWrong) {
    const LetterReading reading = AskedLetters([](const Place& at) {
                                      return std::pair(letterOf(at) == Letter::h ? -1.0 : 1.0, 1.0);
                                  }).read();
    expectAll(reading.h.alongU, &EdgeCount::opposite, 265, 295);
    expectAll(reading.h.alongV, &EdgeCount::right, 143, 161);
    expectAll(reading.l.alongU, &EdgeCount::right, 165, 183);
    EXPECT_FALSE(reading.good());
    const LetterReading other = AskedLetters([](const Place& at) {
                                    return std::pair(1.0, letterOf(at) == Letter::l ? -1.0 : 1.0);
                                }).read();
    expectAll(other.l.alongV, &EdgeCount::opposite, 117, 131);
    expectAll(other.h.alongV, &EdgeCount::right, 143, 161);
    EXPECT_FALSE(other.good());
}

// A change of less than a tenth of that at an edge counts as none; the other letters set the scale.
TEST(ReadLetters, TakesHardlyAnyChangeForNone) {
    const auto faint = [](double times) {
        return AskedLetters([=](const Place& at) {
                   return std::pair(1.0, letterOf(at) == Letter::l ? times : 1.0);
               })
            .read()
            .l.alongV;
    };
    expectAll(faint(0.05), &EdgeCount::lost, 117, 131);
    expectAll(faint(-0.05), &EdgeCount::lost, 117, 131);
    expectAll(faint(0.15), &EdgeCount::right, 117, 131);
    expectAll(faint(-0.15), &EdgeCount::opposite, 117, 131);
}

TEST(DrawRelief, ShowsTheMapAndTheSameReliefOfARightReading) {
    const AskedLetters run(rightTimes);
    const std::vector<Raster> rasters =
        drawRelief(run.plan, run.answers, tests::kParametrisation, run.response);
    ASSERT_EQ(rasters.size(), 2U);
    for (const Raster& raster : rasters) {
        ASSERT_EQ(raster.values.size(), 128U * 64U);
        EXPECT_NEAR(*std::min_element(raster.values.begin(), raster.values.end()), 0.1F, 0.1F);
        EXPECT_NEAR(*std::max_element(raster.values.begin(), raster.values.end()), 0.9F, 0.1F);
    }
    double off = 0.0;
    for (std::size_t i = 0; i < rasters[0].values.size(); ++i) {
        const Vector3& n = run.plan.directions[i];
        const double height = letterHeight(static_cast<int>(tests::kParametrisation.u(n) * 640),
                                           static_cast<int>(tests::kParametrisation.v(n) * 320));
        ASSERT_NEAR(rasters[0].values[i], 0.5 + 0.4 * height, 1e-6) << i;
        off += std::abs(rasters[1].values[i] - rasters[0].values[i]) / (128.0 * 64.0);
    }
    EXPECT_LT(off, 0.05) << "on average, of the whole range";
}

}  // namespace
}  // namespace ticker::tasks::bump
