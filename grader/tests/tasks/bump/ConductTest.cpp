// Behaviour of code at special points, from answers made by hand.
#include <grader/tasks/bump/questions/Conduct.h>
#include <grader/tests/tasks/bump/Asked.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace ticker::tasks::bump {
namespace {

using probe::AnswerState;
using probe::NormalAnswer;

const Ball kBall{{1.0, 2.0, 3.0}, 2.0};
const Vector3 kNothing{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0};

/// One ordinary question of four points, then all of a conduct plan, answered by the smooth sphere
/// with a test's changes.
struct Made {
    Questionnaire questionnaire;
    std::size_t ordinary;
    ConductPlan plan;
    probe::Run run;

    Made() : ordinary(addOrdinary(questionnaire)), plan(addPlan(questionnaire)) {
        selftest::FunctionExaminee smooth([](const selftest::Point& point) {
            return (point.position - point.centre).normalised();
        });
        run = smooth.ask(questionnaire.questions());
    }
    static std::size_t addOrdinary(Questionnaire& questionnaire) {
        return questionnaire.add(
            kBall, flatMap(7, 5),
            {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, 0.6, 0.8}});
    }
    static ConductPlan addPlan(Questionnaire& questionnaire) {
        Draws draws(3);
        return planConduct(questionnaire, draws);
    }
    [[nodiscard]] NormalAnswer& answer(std::size_t question) {
        return std::get<NormalAnswer>(run.answers.at(question));
    }
    [[nodiscard]] Conduct read() const { return readConduct(plan, Answers(questionnaire, run)); }
};

/// The conduct after one odd normal at the second point of a question.
Conduct after(const std::function<std::size_t(const Made&)>& question, const Vector3& normal,
              std::uint32_t exceptions = 0) {
    Made made;
    NormalAnswer& answer = made.answer(question(made));
    answer.normals.at(1) = normal;
    answer.exceptions = exceptions;
    answer.message = "words";
    return made.read();
}

std::size_t ordinary(const Made& made) {
    return made.ordinary;
}

TEST(Conduct, OfASmoothSphereIsFaultless) {
    const Conduct conduct = Made().read();
    for (const Offence* offence :
         {&conduct.threw, &conduct.threwHidden, &conduct.notFinite, &conduct.notFiniteHidden,
          &conduct.notUnit, &conduct.notUnitHidden, &conduct.inward, &conduct.missing})
        EXPECT_FALSE(*offence);
    EXPECT_LT(conduct.largestTilt, 1e-6);
    EXPECT_EQ(conduct.chance, 0.0);
    EXPECT_EQ(conduct.inward.asked, 4.0 + 300.0) << "ordinary points, and those asked for twice";
}

TEST(Conduct, TellsWhereAnOffenceWasAndOnWhichMap) {
    const Conduct conduct = after(ordinary, Vector3{0.0, 1.01, 0.0});
    EXPECT_EQ(conduct.notUnit.count, 1.0);
    EXPECT_NEAR(conduct.notUnit.value, 0.01, 1e-12);
    EXPECT_NEAR(conduct.notUnit.direction.y, 1.0, 1e-12);
    EXPECT_NEAR(conduct.notUnit.direction.x, 0.0, 1e-12);
    EXPECT_EQ(conduct.notUnit.width, 7);
    EXPECT_EQ(conduct.notUnit.height, 5);
    EXPECT_FALSE(conduct.notFinite);
}

TEST(Conduct, CountsAllAndKeepsTheFirstPlaceAndTheLargestError) {
    Made made;
    made.answer(made.ordinary).normals = {
        {1.02, 0.0, 0.0}, {0.0, 0.95, 0.0}, {0.0, 0.0, 1.03}, {0.0, 0.6, 0.8}};
    const Conduct conduct = made.read();
    EXPECT_EQ(conduct.notUnit.count, 3.0);
    EXPECT_NEAR(conduct.notUnit.value, 0.05, 1e-12);
    EXPECT_NEAR(conduct.notUnit.direction.x, 1.0, 1e-12);
}

TEST(Conduct, AllowsAThousandthOfLength) {
    EXPECT_FALSE(after(ordinary, {0.0, 1.0 + 0.9e-3, 0.0}).notUnit);
    EXPECT_FALSE(after(ordinary, {0.0, 1.0 - 0.9e-3, 0.0}).notUnit);
    EXPECT_TRUE(after(ordinary, {0.0, 1.0 + 1.1e-3, 0.0}).notUnit);
    EXPECT_TRUE(after(ordinary, {0.0, 1.0 - 1.1e-3, 0.0}).notUnit);
}

TEST(Conduct, MeasuresTheLargestTiltAndWhatPointsInwards) {
    const Conduct tilted = after(ordinary, {0.6, 0.8, 0.0});
    EXPECT_NEAR(tilted.largestTilt, 0.75, 1e-9);
    EXPECT_FALSE(tilted.inward);
    const Conduct inward = after(ordinary, {0.6, -0.8, 0.0});
    EXPECT_EQ(inward.inward.count, 1.0);
    EXPECT_LT(inward.largestTilt, 1e-6);
    EXPECT_TRUE(after(ordinary, {1.0, 0.0, 0.0}).inward) << "at a right angle";
    const Conduct rough = after([](const Made& m) { return m.plan.smallMap; }, {1e-9, 0.0, -1.0});
    EXPECT_FALSE(rough.inward) << "on a map of random texels";
}

TEST(Conduct, TellsWhetherTwoMapsGiveTheSameNormals) {
    Made made;
    EXPECT_TRUE(made.read().sameOnOtherMap) << "a smooth sphere";
    Vector3& first = made.answer(made.plan.afterOtherMap.back()).normals.front();
    first = (first + Vector3{1e-6, 2e-6, 3e-6}).normalised();
    EXPECT_FALSE(made.read().sameOnOtherMap) << "one normal of another map";
    first = kNothing;
    EXPECT_FALSE(made.read().sameOnOtherMap);
}

TEST(Conduct, TellsExceptionsFromWhatIsNoNumberAndWhatIsMissing) {
    const Conduct odd = after(ordinary, kNothing);
    EXPECT_EQ(odd.notFinite.count, 1.0);
    EXPECT_FALSE(odd.threw);
    const Conduct threw = after(ordinary, kNothing, 1);
    EXPECT_EQ(threw.threw.count, 1.0);
    EXPECT_EQ(threw.threw.message, "words");
    EXPECT_FALSE(threw.notFinite);
    Made made;
    made.answer(made.ordinary).normals.assign(4, kNothing);
    made.answer(made.ordinary).exceptions = 3;
    EXPECT_EQ(made.read().threw.count, 3.0);
    EXPECT_EQ(made.read().notFinite.count, 1.0);
    made.answer(made.ordinary).state = AnswerState::missing;
    EXPECT_EQ(made.read().missing.count, 4.0);
    EXPECT_FALSE(made.read().threw);
}

TEST(Conduct, KeepsApartWhatNoPictureShows) {
    struct Row {
        std::size_t ConductPlan::*question;
        bool ends;   // an exception counts
        bool shows;  // an odd value counts
    };
    for (const Row& row :
         {Row{&ConductPlan::visibleMeridian, true, true},
          Row{&ConductPlan::hiddenMeridian, false, false},
          Row{&ConductPlan::nearestPoint, true, false}, Row{&ConductPlan::lastRows, true, true},
          Row{&ConductPlan::poles, false, false}, Row{&ConductPlan::smallMap, true, true},
          Row{&ConductPlan::tinyMap, false, false}, Row{&ConductPlan::twice, true, true}}) {
        const auto question = [&](const Made& made) { return made.plan.*(row.question); };
        const Conduct odd = after(question, kNothing);
        EXPECT_EQ(static_cast<bool>(odd.notFinite), row.shows);
        EXPECT_EQ(static_cast<bool>(odd.notFiniteHidden), !row.shows);
        const Conduct threw = after(question, kNothing, 1);
        EXPECT_EQ(static_cast<bool>(threw.threw), row.ends);
        EXPECT_EQ(static_cast<bool>(threw.threwHidden), !row.ends);
        const Conduct loose = after(question, {0.0, 0.0, 2.0});
        EXPECT_EQ(static_cast<bool>(loose.notUnit), row.shows);
        EXPECT_EQ(static_cast<bool>(loose.notUnitHidden), !row.shows);
    }
}

TEST(Conduct, SeesANormalThatChangesFromOneTimeToTheNext) {
    Made made;
    std::vector<Vector3>& normals = made.answer(made.plan.twice).normals;
    ASSERT_EQ(normals.size(), 300U);
    for (std::size_t i = 150; i < 300; ++i)
        normals[i] = (normals[i] + Vector3{0.0, 0.0, 0.3}).normalised();
    EXPECT_TRUE(made.read().chance > 0.15 && made.read().chance < 0.3);
}

TEST(PlanConduct, AsksWhereCoordinatesEnd) {
    const Made made;
    const auto directions = [&](std::size_t question) {
        const probe::NormalQuestion& asked = made.questionnaire.question(question);
        std::vector<Vector3> all;
        for (const Vector3& position : asked.positions)
            all.push_back((position - asked.centre) / asked.radius);
        return all;
    };
    const std::vector<Vector3> visible = directions(made.plan.visibleMeridian);
    ASSERT_EQ(visible.size(), 19U * 8U);
    for (const Vector3& n : visible) {
        EXPECT_LT(std::min(std::abs(n.x), std::abs(n.y)), 1e-15);
        EXPECT_LT(n.z, -0.3) << "on the near side";
        EXPECT_NEAR(n.magnitude(), 1.0, 1e-9);
    }
    for (const Vector3& n : directions(made.plan.hiddenMeridian)) {
        EXPECT_LT(std::min({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), 1e-15);
        EXPECT_GT(n.z, -1e-9) << "on the far side";
        EXPECT_NEAR(n.magnitude(), 1.0, 1e-9);
    }
    const auto offAxis = [](const Vector3& n) {
        return std::acos(std::min(1.0, std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)})));
    };
    int ends[6] = {0, 0, 0, 0, 0, 0};
    for (const Vector3& n : directions(made.plan.lastRows)) {
        EXPECT_TRUE(offAxis(n) > 0.009 && offAxis(n) < 0.041) << offAxis(n);
        for (int axis = 0; axis < 3; ++axis) {
            const double along = axis == 0 ? n.x : axis == 1 ? n.y : n.z;
            if (along > 0.9) ++ends[axis];
            if (along < -0.9) ++ends[3 + axis];
        }
    }
    for (const int points : ends)
        EXPECT_EQ(points, 48);
    EXPECT_EQ(directions(made.plan.poles).size(), 30U);
    for (const Vector3& n : directions(made.plan.poles))
        EXPECT_LT(offAxis(n), 1.1e-4);
    EXPECT_EQ(made.questionnaire.question(made.plan.smallMap).map.bytes.size(), 256U);
}

}  // namespace
}  // namespace ticker::tasks::bump
