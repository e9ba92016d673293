// Slopes as in pictures, and the regions of a large map, for submissions made by hand.
#include <grader/tasks/bump/questions/Regions.h>
#include <grader/tasks/bump/questions/Slopes.h>
#include <grader/tests/tasks/bump/Asked.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ticker::tasks::bump {
namespace {

using tests::Place;

const Parametrisation kParametrisation({0.0, 1.0, 0.0}, 0.5, false);
const Ball kBall{{0.0, 0.0, 20.0}, 12.0};

using Times = std::function<std::pair<double, double>(const Place&, const selftest::Point&)>;

std::pair<double, double> right(const Place&, const selftest::Point&) {
    return {1.0, 1.0};
}

Response evenResponse() {
    Response response;
    response.u.bandStrength.fill(1.0);
    response.v.bandStrength.fill(1.0);
    response.u.sense = response.v.sense = Sense::right;
    return response;
}

SlopeAgreement slopesOf(const Times& times, const Response& response = evenResponse()) {
    Questionnaire questionnaire;
    Draws draws(4);
    const SlopePlan plan = planSlopes(questionnaire, draws, kBall);
    const Answers answers =
        tests::answersOf(questionnaire, tests::inProportion(kParametrisation, times));
    return readSlopes(plan, answers, kParametrisation, response);
}

TEST(ReadSlopes, AgreesWithARightReadingEverywhere) {
    const SlopeAgreement agreement = slopesOf(right);
    EXPECT_GT(agreement.sawtoothU, 0.94) << "but for the teeth's ends";
    EXPECT_GT(agreement.sawtoothV, 0.94);
    EXPECT_NEAR(agreement.fieldU, 1.0, 1e-9);
    EXPECT_NEAR(agreement.fieldV, 1.0, 1e-9);
    EXPECT_NEAR(agreement.smallU, 1.0, 1e-9);
    EXPECT_NEAR(agreement.smallV, 1.0, 1e-9);
}

TEST(ReadSlopes, SeesSlopesThatDifferOnASmallSphereAlone) {
    const SlopeAgreement agreement = slopesOf([](const Place& at, const selftest::Point& point) {
        // Half of the points along u, by their column.
        return std::pair(point.radius < 0.1 && at.column % 2 == 0 ? -1.0 : 1.0, 1.0);
    });
    EXPECT_TRUE(agreement.good());
    EXPECT_FALSE(agreement.smallAgrees());
    EXPECT_LT(std::abs(agreement.smallU), 0.3);
    EXPECT_NEAR(agreement.smallV, 1.0, 1e-9);
}

TEST(ReadSlopes, TakesTheSignThatTheRampsHave) {
    const Times inverted = [](const Place&, const selftest::Point&) {
        return std::pair(-1.0, 1.0);
    };
    EXPECT_LT(slopesOf(inverted).sawtoothU, 0.06);
    EXPECT_NEAR(slopesOf(inverted).fieldU, -1.0, 1e-9);
    Response response = evenResponse();
    response.u.sense = Sense::inverted;
    EXPECT_GT(slopesOf(inverted, response).sawtoothU, 0.94);
    EXPECT_NEAR(slopesOf(inverted, response).fieldU, 1.0, 1e-9);
    response = evenResponse();
    response.v.sense = Sense::inverted;
    EXPECT_NEAR(slopesOf(right, response).fieldV, -1.0, 1e-9);
}

// In the upper half of the map one axis is wrong.
TEST(ReadSlopes, CountsTheShareThatLeansTheOtherWay) {
    const SlopeAgreement agreement = slopesOf([](const Place& at, const selftest::Point&) {
        return std::pair(1.0, at.v < 0.5 ? -1.0 : 1.0);
    });
    EXPECT_NEAR(agreement.fieldU, 1.0, 1e-9);
    EXPECT_NEAR(agreement.fieldV, 0.0, 0.3);
    EXPECT_NEAR(agreement.sawtoothV, 0.5, 0.1);
    EXPECT_GT(agreement.sawtoothU, 0.94);
}

TEST(ReadSlopes, LeavesOutPointsThatAreNotTiltedAtAll) {
    const SlopeAgreement agreement = slopesOf([](const Place& at, const selftest::Point&) {
        return std::pair(at.u < 0.5 ? 0.0 : 1.0, 1.0);
    });
    EXPECT_GT(agreement.sawtoothU, 0.94);
    EXPECT_NEAR(agreement.fieldU, 1.0, 1e-9);
}

TEST(PlanSlopes, HasTeethOfFourBytesAndASmoothFieldOfAlmostAllBytes) {
    Questionnaire questionnaire;
    Draws draws(4);
    const SlopePlan plan = planSlopes(questionnaire, draws, kBall);
    const auto& columns = questionnaire.question(plan.sawtoothU.map).map.columns;
    ASSERT_EQ(columns.size(), 1024U);
    for (std::size_t i = 1; i < columns.size(); ++i)
        EXPECT_NEAR((columns[i] - columns[i - 1]) / kByte, i % 64 == 0 ? -252.0 : 4.0, 1e-9) << i;
    const auto& field = questionnaire.question(plan.field.map).map;
    const auto [least, most] = std::minmax_element(field.bytes.begin(), field.bytes.end());
    EXPECT_EQ(static_cast<int>(*least), 32);
    EXPECT_EQ(static_cast<int>(*most), 224);
    int steepest = 0;
    for (int row = 0; row < field.height; ++row)
        for (int column = 0; column < field.width; ++column) {
            const auto at = [&](int c) {
                return static_cast<int>(
                    field.bytes[static_cast<std::size_t>(row * field.width + c % field.width)]);
            };
            steepest = std::max(steepest, std::abs(at(column + 1) - at(column)));
        }
    EXPECT_LT(steepest, 30) << "smooth, over the seam as well";
    EXPECT_EQ(questionnaire.question(plan.field.flat).map.width, field.width);
}

TEST(SlopeAlong, IsTheDifferenceOverTwoTexels) {
    probe::HeightMapDescription map{4, 3, {}, {}, {}};
    for (int row = 0; row < 3; ++row)
        for (const int byte : {10, 13, 20, 50})
            map.bytes.push_back(static_cast<std::uint8_t>(byte + 7 * row * row));
    EXPECT_NEAR(slopeAlongU(map, 0.3, 0.1), 5.0 * kByte, 1e-12);
    EXPECT_NEAR(slopeAlongU(map, 0.1, 0.5), -18.5 * kByte, 1e-12) << "round the seam";
    EXPECT_NEAR(slopeAlongU(map, 1.0, 0.9), -5.0 * kByte, 1e-12);
    EXPECT_NEAR(slopeAlongV(map, 0.3, 0.5), 14.0 * kByte, 1e-12);
    EXPECT_NEAR(slopeAlongV(map, 0.3, 0.0), 3.5 * kByte, 1e-12) << "the first row again";
    EXPECT_NEAR(slopeAlongV(map, 0.9, 1.0), 10.5 * kByte, 1e-12);
}

/// The judgement of gentle ramps, for a submission whose tilts are this factor times the slope.
RampJudgement judgementOf(double strength) {
    RampJudgement judgement;
    judgement.shape = {1001, 801, 90, 0.5, 2.0};
    judgement.fit = ParametrisationFit{kParametrisation};
    judgement.response = evenResponse();
    judgement.response->u.bandStrength.fill(strength * 0.5 / 1000);
    judgement.response->v.bandStrength.fill(strength * 0.5 / 800);
    return judgement;
}

RegionAgreement regionsOf(const Times& times, double strength = 1.0,
                          const Parametrisation& parametrisation = kParametrisation) {
    Questionnaire questionnaire;
    Draws draws(4);
    const RegionPlan plan = planRegions(questionnaire, draws, kBall, draws.directions(2000));
    const Answers answers =
        tests::answersOf(questionnaire, tests::inProportion(parametrisation, times));
    RampJudgement ramps = judgementOf(strength);
    ramps.fit = ParametrisationFit{parametrisation};
    return readRegions(plan, answers, ramps);
}

TEST(ReadRegions, AgreesWithARightReadingEverywhere) {
    const RegionAgreement agreement = regionsOf(right);
    for (const RegionShares& shares : {agreement.u, agreement.v}) {
        EXPECT_GT(shares.asOnRamps, 0.94);
        EXPECT_LT(shares.asOnRamps, 1.0) << "the teeth's ends";
        EXPECT_GT(shares.worst, 0.8);
        EXPECT_EQ(shares.best, 1.0);
        EXPECT_FALSE(shares.columns);
        EXPECT_FALSE(shares.rows);
    }
    EXPECT_TRUE(agreement.width >= 860 && agreement.width <= 900);
    EXPECT_TRUE(agreement.height >= 640 && agreement.height <= 680);
}

TEST(ReadRegions, NamesTheRowsAndTheColumnsThatStray) {
    const RegionAgreement rows = regionsOf([](const Place& at, const selftest::Point&) {
        return std::pair(at.v > 0.25 && at.v < 0.5 ? -1.0 : 1.0, 1.0);
    });
    ASSERT_TRUE(rows.u.rows);
    EXPECT_FALSE(rows.u.columns);
    EXPECT_NEAR(rows.u.rows->first, 0.25 * rows.height, rows.height / 64.0);
    EXPECT_NEAR(rows.u.rows->last, 0.5 * rows.height, rows.height / 64.0);
    EXPECT_LT(rows.u.worst, 0.1);
    EXPECT_GT(rows.u.best, 0.9);
    EXPECT_NEAR(rows.u.asOnRamps, 1.0 - 0.5 * std::cos(std::numbers::pi / 4.0), 0.05);
    EXPECT_GT(rows.v.asOnRamps, 0.94);
    const RegionAgreement columns = regionsOf([](const Place& at, const selftest::Point&) {
        return std::pair(1.0, at.u > 0.5 && at.u < 0.75 ? -1.0 : 1.0);
    });
    ASSERT_TRUE(columns.v.columns);
    EXPECT_FALSE(columns.v.rows);
    EXPECT_NEAR(columns.v.columns->first, 0.5 * columns.width, columns.width / 64.0);
    EXPECT_NEAR(columns.v.columns->last, 0.75 * columns.width, columns.width / 64.0);
    EXPECT_NEAR(columns.v.asOnRamps, 0.75, 0.05);
}

// Rows of a few points count, and there are few near a pole.
TEST(ReadRegions, NamesRowsNearAPole) {
    const RegionAgreement top = regionsOf([](const Place& at, const selftest::Point&) {
        return std::pair(1.0, at.v < 0.14 ? -1.0 : 1.0);
    });
    ASSERT_TRUE(top.v.rows);
    EXPECT_LT(top.v.rows->first, 0.07 * top.height);
    EXPECT_NEAR(top.v.rows->last, 0.14 * top.height, top.height / 64.0);
}

TEST(ReadRegions, NamesNoneWhereAllStrayOrThoseAreSpreadOut) {
    const RegionAgreement all =
        regionsOf([](const Place&, const selftest::Point&) { return std::pair(-1.0, 1.0); });
    EXPECT_LT(all.u.asOnRamps, 0.06);
    EXPECT_FALSE(all.u.columns);
    EXPECT_FALSE(all.u.rows);
    const RegionAgreement mixed = regionsOf([](const Place& at, const selftest::Point&) {
        return std::pair((at.column + at.row) % 2 == 0 ? -1.0 : 1.0, 1.0);
    });
    EXPECT_NEAR(mixed.u.asOnRamps, 0.5, 0.06);
    EXPECT_FALSE(mixed.u.rows);
}

// The limit is a fiftieth of the tilt that the ramps have at this slope.
TEST(ReadRegions, CallsATiltThatIsTooWeakAStray) {
    EXPECT_GT(regionsOf(right, 1.0 / 0.0205).u.asOnRamps, 0.94);
    EXPECT_LT(regionsOf(right, 1.0 / 0.0185).u.asOnRamps, 0.1);
    EXPECT_GT(regionsOf(right, 1.0 / 0.0205).v.asOnRamps, 0.94);
    EXPECT_LT(regionsOf(right, 1.0 / 0.0185).v.asOnRamps, 0.1);
}

TEST(AreTheSame, WantsTheSameTiltsAtAlmostAllPoints) {
    const auto same = [](double share, double tilt, double off) {
        Questionnaire questionnaire;
        Draws draws(4);
        const std::vector<Vector3> directions = draws.directions(200);
        const std::size_t one = questionnaire.add(kBall, flatMap(10, 10, 1.0), directions);
        const std::size_t two = questionnaire.add(kBall, flatMap(10, 10, 2.0), directions);
        const Answers answers = tests::answersOf(questionnaire, [&](const selftest::Point& point) {
            const Vector3 n = (point.position - point.centre).normalised();
            const double more = point.map.at(0, 0) > 1.5 && n.y > 2.0 * share - 1.0 ? off : 0.0;
            return (n + kParametrisation.alongU(n) * (tilt + more)).normalised();
        });
        return areTheSame(answers, one, two);
    };
    EXPECT_TRUE(same(1.0, 0.1, 0.0));
    EXPECT_TRUE(same(0.95, 0.1, 0.01));
    EXPECT_FALSE(same(0.85, 0.1, 0.01));
    EXPECT_FALSE(same(0.5, 0.1, 1e-9));
    EXPECT_FALSE(same(1.0, 0.5e-6, 0.0)) << "both are flat";
}

}  // namespace
}  // namespace ticker::tasks::bump
