// Which ramps are judged, and the hints of the last run, for submissions made by hand.
#include <grader/tasks/bump/Examination.h>
#include <grader/tests/tasks/bump/Asked.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace ticker::tasks::bump {
namespace {

using tests::Place;

using Times = std::function<std::pair<double, double>(const Place&, const selftest::Point&)>;

/// A judgement of coarse ramps, recognisable by its shape.
RampJudgement coarse(RampKind kind, bool responds) {
    RampJudgement judgement;
    judgement.kind = kind;
    judgement.shape.rise = 77.0;
    judgement.fit = ParametrisationFit{tests::kParametrisation};
    if (responds) {
        judgement.response = Response{};
        judgement.response->u.bandStrength.fill(1.0);
        judgement.response->v.bandStrength.fill(1.0);
    }
    return judgement;
}

/// Whether the judgement of coarse ramps replaces that of the other ramps.
bool coarseCounts(const Times& times, RampKind kind, bool responds) {
    const MainPlan plan = planMain(8);
    const Answers answers =
        tests::answersOf(plan.questionnaire, tests::inProportion(tests::kParametrisation, times));
    const Examination examination = examine(plan, answers, coarse(kind, responds));
    EXPECT_EQ(examination.regions.has_value(), examination.ramps().response.has_value());
    return examination.ramps().shape.rise == 77.0;
}

TEST(Examine, TakesCoarseRampsWhereTheyTellMore) {
    const Times level = [](const Place&, const selftest::Point&) { return std::pair(0.0, 0.0); };
    EXPECT_TRUE(coarseCounts(level, RampKind::right, true));
    EXPECT_TRUE(coarseCounts(level, RampKind::slopeUIgnored, false));
    EXPECT_FALSE(coarseCounts(level, RampKind::silent, false));
    // The ramps tilt, but no place on the map follows from them.
    const Times strange = [](const Place& at, const selftest::Point&) {
        return std::pair(std::sin(50.0 * at.u), std::cos(70.0 * at.v));
    };
    EXPECT_TRUE(coarseCounts(strange, RampKind::right, true));
    EXPECT_FALSE(coarseCounts(strange, RampKind::slopeUIgnored, false));
}

Hints hintsOf(const selftest::NormalFunction& function) {
    const HintPlan plan = planHints(8);
    return readHints(plan, tests::answersOf(plan.questionnaire, function));
}

Hints hintsOf(const Times& times) {
    return hintsOf(tests::inProportion(tests::kParametrisation, times));
}

TEST(ReadHints, FindNothingInARightReading) {
    const Hints hints =
        hintsOf([](const Place&, const selftest::Point&) { return std::pair(5.0, 5.0); });
    for (const RampJudgement& ramps :
         {hints.square, hints.unitSphere, hints.sceneSphere, hints.asideSphere})
        EXPECT_EQ(ramps.kind, RampKind::right);
    EXPECT_TRUE(hints.lastColumnsSeen);
    EXPECT_TRUE(hints.lastRowsSeen);
    EXPECT_FALSE(hints.dependsOnOrder);
}

TEST(ReadHints, TellThatTheCentreIsLeftOut) {
    const selftest::NormalFunction right = tests::inProportion(
        tests::kParametrisation,
        [](const Place&, const selftest::Point&) { return std::pair(5.0, 5.0); });
    const Hints hints = hintsOf([&](const selftest::Point& point) {
        selftest::Point wrong = point;
        wrong.centre.x = 0.0;
        return right(wrong);
    });
    EXPECT_NE(hints.asideSphere.kind, RampKind::right);
}

TEST(ReadHints, TellColumnsAndRowsThatAreNeverRead) {
    const Hints columns = hintsOf([](const Place& at, const selftest::Point& point) {
        return std::pair(at.column < point.map.width() / 2 ? 5.0 : 0.0, 5.0);
    });
    EXPECT_FALSE(columns.lastColumnsSeen);
    EXPECT_TRUE(columns.lastRowsSeen);
    const Hints rows = hintsOf([](const Place& at, const selftest::Point& point) {
        return std::pair(5.0, at.row < point.map.height() / 2 ? 5.0 : 0.0);
    });
    EXPECT_TRUE(rows.lastColumnsSeen);
    EXPECT_FALSE(rows.lastRowsSeen);
    const auto seenWithin = [](double share) {
        return hintsOf([=](const Place& at, const selftest::Point&) {
                   return std::pair(at.u > 1.0 - share ? 5.0 : 0.0, 5.0);
               })
            .lastColumnsSeen;
    };
    EXPECT_FALSE(seenWithin(0.008)) << "less than one point of fifty";
    EXPECT_TRUE(seenWithin(0.05));
    const auto tilted = [](double times) {
        return hintsOf([=](const Place&, const selftest::Point&) { return std::pair(times, 5.0); })
            .lastColumnsSeen;
    };
    constexpr double kSomeTilt = 2e-5;   // as in Examination.cpp
    constexpr double kGentlest = 0.157;  // slope of eight bytes for each texel
    constexpr double kSteepest = 2.36;   // slope of 120 bytes, at a tooth's end
    EXPECT_FALSE(tilted(0.95 * kSomeTilt / kSteepest)) << "no slope tilts enough";
    EXPECT_TRUE(tilted(1.05 * kSomeTilt / kGentlest)) << "every slope does";
}

TEST(ReadHints, TellThatTheOrderOfThePointsMatters) {
    const auto dependsOn = [](int every, double by) {
        int asked = 0;
        const auto plain = tests::inProportion(
            tests::kParametrisation,
            [](const Place&, const selftest::Point&) { return std::pair(5.0, 5.0); });
        return hintsOf([&, plain](const selftest::Point& point) {
                   const double more = asked++ % every == 0 ? by : 0.0;
                   return plain(point) + Vector3{0.0, 0.0, more};
               })
            .dependsOnOrder;
    };
    EXPECT_TRUE(dependsOn(20, 1e-3));
    EXPECT_FALSE(dependsOn(400, 1e-3)) << "a few points";
    EXPECT_FALSE(dependsOn(20, 1e-11)) << "rounding";
}

TEST(Examination, AgreesWhereEveryMapDoes) {
    Examination examination;
    examination.ladder.steepAgrees = 0.96;
    examination.regions = RegionAgreement{};
    examination.slopes = SlopeAgreement{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
    EXPECT_TRUE(examination.agreesWithRamps());
    Examination other = examination;
    other.ladder.steepAgrees = 0.94;
    EXPECT_FALSE(other.agreesWithRamps());
    other = examination;
    other.regions->u.worst = 0.1;
    EXPECT_FALSE(other.agreesWithRamps());
    other = examination;
    other.slopes->fieldU = 0.1;
    EXPECT_FALSE(other.agreesWithRamps());
    other = examination;
    other.regions.reset();
    EXPECT_FALSE(other.agreesWithRamps());
    other = examination;
    other.slopes.reset();
    EXPECT_FALSE(other.agreesWithRamps());
}

}  // namespace
}  // namespace ticker::tasks::bump
