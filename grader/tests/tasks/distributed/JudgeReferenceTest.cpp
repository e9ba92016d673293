#include <grader/tasks/JudgeDistributed.h>
#include <grader/tests/support/LocalExaminee.h>

#include <gtest/gtest.h>

#include <string>

namespace ticker::tasks {
namespace {

std::string told(const TaskJudgement& judgement) {
    std::string text = judgement.reason;
    for (const Finding& finding : judgement.findings)
        text += finding.id + ": " + finding.message + "\n";
    return text;
}

// A correct submission fails with a chance below 1e-9 for each seed.
TEST(JudgeDistributed, PassesTheReferenceForManySeeds) {
    tests::LocalExaminee examinee;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        const DistributedJudgement judgement = judgeDistributed(examinee, {}, seed);
        EXPECT_EQ(judgement.softShadows.state, TaskState::passed)
            << seed << " " << told(judgement.softShadows);
        EXPECT_TRUE(judgement.softShadows.findings.empty()) << told(judgement.softShadows);
        EXPECT_FALSE(judgement.softShadows.needsReview);
        EXPECT_EQ(judgement.depthOfField.state, TaskState::passed)
            << seed << " " << told(judgement.depthOfField);
        EXPECT_TRUE(judgement.depthOfField.findings.empty()) << told(judgement.depthOfField);
        EXPECT_FALSE(judgement.depthOfField.needsReview);
    }
}

}  // namespace
}  // namespace ticker::tasks
