// The tilt's direction near the poles.
#include <grader/tasks/bump/places/Caps.h>
#include <grader/tests/tasks/bump/Asked.h>
#include <grader/tests/tasks/bump/Judging.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ticker::tasks::bump {
namespace {

using selftest::Point;

Caps capsOf(const selftest::NormalFunction& function, const Parametrisation& parametrisation,
            std::uint64_t seed = 4) {
    Questionnaire questionnaire;
    Draws draws(seed);
    const CapPlan plan = planCaps(questionnaire, draws, {{0.5, -1.0, 20.0}, 12.0});
    return readCaps(plan, tests::answersOf(questionnaire, function), parametrisation);
}

/// The right tilts along tangents from a helper vector: y, or z where n.y is at least the limit.
selftest::NormalFunction withHelperBeyond(double limit) {
    return [limit](const Point& point) {
        const Vector3 n = tests::smooth(point);
        const Vector3 up = n.y < limit ? Vector3{0.0, 1.0, 0.0} : Vector3{0.0, 0.0, 1.0};
        const Vector3 tangentU = -up.cross(n).normalised();
        const Vector3 tangentV = n.cross(tangentU);
        // The right tilt's parts, laid along other tangents.
        const Vector3 tilt = tiltOf(selftest::modelNormal({}, selftest::Mistake::none, point), n);
        return (n + tangentU * tilt.dot(tests::kParametrisation.alongU(n)) +
                tangentV * tilt.dot(tests::kParametrisation.alongV(n)))
            .normalised();
    };
}

TEST(ReadCaps, SeesAnotherHelperVectorAtOneEndFromSixDegreesOn) {
    // Of 48 evenly spaced points 16 lean the right way, whatever is drawn.
    for (const double limit : {0.99, 0.995})
        for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
            const Caps caps = capsOf(withHelperBeyond(limit), tests::kParametrisation, seed);
            EXPECT_LT(caps.alongU, 0.5) << limit;
            EXPECT_LT(caps.alongV, 0.5) << limit;
        }
}

TEST(ReadCaps, SeesAPolarAngleThatStopsTwelveDegreesBeforeThePoles) {
    const auto limited = [](const Point& point) {
        constexpr double kMost = 0.978;
        const Vector3 n = tests::smooth(point);
        const double y = std::clamp(n.y, -kMost, kMost);
        const double ring = std::sqrt((1.0 - y * y) / std::max(1.0 - n.y * n.y, 1e-12));
        const Point there{point.map, point.centre, point.radius,
                          point.centre + Vector3{n.x * ring, y, n.z * ring} * point.radius};
        return selftest::modelNormal({}, selftest::Mistake::none, there);
    };
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U})
        EXPECT_LT(capsOf(limited, tests::kParametrisation, seed).alongV, 0.1);
}

TEST(ReadCaps, DoesNotApplyToATiltedAxisNorWhereNothingTilts) {
    const Vector3 tilted = Vector3{0.1, 1.0, 0.0}.normalised();
    EXPECT_TRUE(capsOf(withHelperBeyond(0.99), Parametrisation(tilted, 0.5, false)).good());
    EXPECT_TRUE(capsOf(tests::smooth, tests::kParametrisation).good());
}

TEST(JudgeBump, SaysThatTangentsNearThePolesAreOthers) {
    const TaskJudgement judgement = tests::judge(withHelperBeyond(0.99));
    ASSERT_EQ(tests::firstId(judgement), "bump.wrong");
    EXPECT_NE(judgement.reason.find("Within eight degrees of the poles"), std::string::npos)
        << judgement.reason;
}

}  // namespace
}  // namespace ticker::tasks::bump
