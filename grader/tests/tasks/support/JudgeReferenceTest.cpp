#include <grader/tasks/lens/JudgeLens.h>
#include <grader/tasks/shadows/JudgeShadows.h>
#include <grader/tests/support/LocalExaminee.h>
#include <grader/tests/support/SlowRun.h>

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
TEST(JudgeBoth, PassTheReferenceForManySeeds) {
    tests::LocalExaminee examinee;
    const std::uint64_t last = tests::isSlowRun() ? 30 : 4;
    for (std::uint64_t seed = 1; seed <= last; ++seed)
        for (const TaskJudgement& judgement :
             {judgeShadows(examinee, seed), judgeLens(examinee, seed)}) {
            EXPECT_EQ(judgement.state, TaskState::passed) << seed << " " << told(judgement);
            EXPECT_TRUE(judgement.findings.empty()) << told(judgement);
            EXPECT_FALSE(judgement.needsReview);
        }
}

}  // namespace
}  // namespace ticker::tasks
