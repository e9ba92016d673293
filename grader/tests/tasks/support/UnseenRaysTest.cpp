#include <grader/tasks/lens/JudgeLens.h>
#include <grader/tasks/shadows/JudgeShadows.h>
#include <grader/tests/support/LocalExaminee.h>
#include <grader/tests/tasks/support/AlteredExaminee.h>

#include <gtest/gtest.h>

#include <string>

namespace ticker::tasks {
namespace {

using raytracer::RenderSettings;

std::string firstOf(const TaskJudgement& judgement) {
    return judgement.findings.empty() ? "" : judgement.findings.front().id;
}

// The reference, judged by its values and pictures alone. A correct submission fails a stage with a
// chance below 1e-7, and only a second failure counts.
TEST(UnseenRays, PassTheReferenceWithANote) {
    tests::LocalExaminee reference;
    AlteredExaminee blind{reference, nullptr, true};
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const TaskJudgement shadows = judgeShadows(blind, seed);
        EXPECT_EQ(shadows.state, TaskState::passed) << seed;
        EXPECT_EQ(firstOf(shadows), "shadow.unseen-rays");
        EXPECT_FALSE(shadows.needsReview);
        const TaskJudgement lens = judgeLens(blind, seed);
        EXPECT_EQ(lens.state, TaskState::passed) << seed;
        EXPECT_EQ(firstOf(lens), "dof.unseen-rays");
        EXPECT_FALSE(lens.needsReview);
    }
}

struct Altered {
    const char* task;
    const char* expected;
    AlteredExaminee::Alter alter;
    bool hideRays;
};

// Each is missed with a chance below 1e-4.
TEST(AlteredSettings, AreNamedWithAndWithoutRays) {
    const std::vector<Altered> cases{
        {"T2.1", "shadow.light-size", [](RenderSettings& s) { s.lightSize *= 0.9; }, false},
        {"T2.1", "shadow.light-size", [](RenderSettings& s) { s.lightSize *= 1.05; }, false},
        {"T2.1", "shadow.light-size", [](RenderSettings& s) { s.lightSize *= 0.9; }, true},
        {"T2.1", "shadow.light-size", [](RenderSettings& s) { s.lightSize *= 1.1; }, true},
        {"T2.1", "shadow.too-few-rays", [](RenderSettings& s) { s.shadowRayCount -= 1; }, false},
        {"T2.1", "shadow.too-few-rays", [](RenderSettings& s) { s.shadowRayCount -= 1; }, true},
        {"T2.2", "dof.aperture-size", [](RenderSettings& s) { s.dofAmount *= 1.4; }, false},
        {"T2.2", "dof.aperture-size", [](RenderSettings& s) { s.dofAmount *= 0.7; }, true},
        {"T2.2", "dof.focal-plane", [](RenderSettings& s) { s.dofFocalPlane *= 1.05; }, false},
        {"T2.2", "dof.focal-plane", [](RenderSettings& s) { s.dofFocalPlane *= 1.2; }, true},
        {"T2.2", "dof.too-few-rays", [](RenderSettings& s) { s.dofRayCount -= 1; }, false},
        {"T2.2", "dof.too-few-rays", [](RenderSettings& s) { s.dofRayCount = 25; }, true}};
    tests::LocalExaminee reference;
    for (const Altered& altered : cases) {
        AlteredExaminee examinee{reference, altered.alter, altered.hideRays};
        const auto judge = std::string{altered.task} == "T2.1" ? judgeShadows : judgeLens;
        const TaskJudgement own = judge(examinee, 3);
        EXPECT_EQ(own.state, TaskState::failed) << altered.expected << altered.hideRays;
        EXPECT_EQ(firstOf(own), altered.expected) << altered.hideRays;
    }
}

TEST(JudgeShadows, SaysTheSameForTheSameSeed) {
    tests::LocalExaminee reference;
    AlteredExaminee examinee{reference, [](RenderSettings& s) { s.lightSize *= 1.3; }};
    const TaskJudgement first = judgeShadows(examinee, 9);
    const TaskJudgement second = judgeShadows(examinee, 9);
    ASSERT_FALSE(first.findings.empty());
    EXPECT_EQ(first.findings[0].message, second.findings[0].message);
    EXPECT_EQ(first.findings[0].evidence, second.findings[0].evidence);
}

TEST(JudgeShadowsOfMany, JudgesAsTheJudgeOfOneDoes) {
    tests::LocalExaminee reference;
    const Judge ofMany = judgeShadowsOfMany();
    for (const double size : {1.0, 1.1, 1.3}) {
        AlteredExaminee examinee{reference, [=](RenderSettings& s) { s.lightSize *= size; }, true};
        const TaskJudgement kept = ofMany(examinee, 3);
        const TaskJudgement alone = judgeShadows(examinee, 3);
        EXPECT_EQ(kept.state, alone.state) << size;
        EXPECT_EQ(kept.findings.back().evidence, alone.findings.back().evidence) << size;
    }
}

}  // namespace
}  // namespace ticker::tasks
