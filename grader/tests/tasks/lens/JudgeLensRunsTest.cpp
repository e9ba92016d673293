// T2.2 judged from answers: the reference, and what only a second picture shows.
#include <grader/tasks/lens/JudgeLens.h>
#include <grader/tests/support/LocalExaminee.h>
#include <grader/tests/tasks/support/AlteredExaminee.h>

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

namespace ticker::tasks {
namespace {

/// The reference; from the second run on the second picture of a run has one ray for each pixel.
class ForgetsRays final : public probe::Examinee {
public:
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        ++runs_;
        if (runs_ == 1 || questions.size() != 2) return reference_.ask(questions);
        AlteredExaminee poor{reference_, [](auto& settings) { settings.dofRayCount = 1; }};
        probe::Run run = reference_.ask(questions);
        run.answers[1] = poor.ask({questions[1]}).answers.at(0);
        return run;
    }

private:
    tests::LocalExaminee reference_;
    int runs_ = 0;
};

// A correct submission fails with a chance below 1e-9.
TEST(JudgeLens, PassesTheReferenceWithoutReview) {
    tests::LocalExaminee reference;
    const TaskJudgement judgement = judgeLens(reference, 2);
    EXPECT_EQ(judgement.state, TaskState::passed);
    EXPECT_TRUE(judgement.findings.empty());
    EXPECT_FALSE(judgement.needsReview);
    EXPECT_EQ(judgement.apertureFactor, 1.0);
}

TEST(JudgeLens, LooksAtTheNextPictureOfARun) {
    ForgetsRays examinee;
    const TaskJudgement judgement = judgeLens(examinee, 2);
    EXPECT_EQ(judgement.state, TaskState::failed);
    ASSERT_FALSE(judgement.findings.empty());
}

}  // namespace
}  // namespace ticker::tasks
