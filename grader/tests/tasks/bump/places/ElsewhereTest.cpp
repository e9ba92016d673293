// Normals that depend on where the eye is.
#include <grader/tasks/bump/places/Elsewhere.h>
#include <grader/tasks/bump/places/Untilted.h>
#include <grader/tests/tasks/bump/Asked.h>
#include <grader/tests/tasks/bump/Judging.h>

#include <gtest/gtest.h>

#include <cstdint>

namespace ticker::tasks::bump {
namespace {

using selftest::Point;

double changedBy(const selftest::NormalFunction& function, std::uint64_t seed = 4) {
    Questionnaire questionnaire;
    Draws draws(seed);
    const UntiltedPlan untilted = planUntilted(questionnaire, draws, {{0.5, -1.0, 20.0}, 12.0});
    const ElsewherePlan plan = planElsewhere(questionnaire, untilted.at(Whereabouts::atRim).map);
    return readElsewhere(plan, tests::answersOf(questionnaire, function)).changed;
}

Vector3 reference(const Point& point) {
    return selftest::modelNormal({}, selftest::Mistake::none, point);
}

TEST(ReadElsewhere, SeesANormalThatIsTurnedToTheEye) {
    EXPECT_GT(changedBy([](const Point& point) {
                  const Vector3 tilted = reference(point);
                  return tilted.dot(point.position) > 0.0 ? -tilted : tilted;
              }),
              0.25);
}

TEST(ReadElsewhere, SeesANormalThatIsMirroredOnlyOnTheSideThatFacesTheEye) {
    const auto mirrored = [](const Point& point) {
        const Vector3 toEye = (-point.position).normalised();
        const Vector3 tilted = reference(point);
        const double facing = tilted.dot(toEye);
        const bool isSeen = tests::smooth(point).dot(toEye) > 0.0;
        return isSeen && facing < 0.0 ? (tilted - toEye * (2.0 * facing)).normalised() : tilted;
    };
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U})
        EXPECT_GT(changedBy(mirrored, seed), 0.25);
    const TaskJudgement judgement = tests::judge(mirrored);
    ASSERT_EQ(tests::firstId(judgement), "bump.wrong");
    EXPECT_NE(judgement.reason.find("depends on where the eye is"), std::string::npos)
        << judgement.reason;
}

}  // namespace
}  // namespace ticker::tasks::bump
