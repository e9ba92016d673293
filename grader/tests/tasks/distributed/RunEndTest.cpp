#include <grader/tasks/JudgeDistributed.h>

#include <gtest/gtest.h>

#include <variant>

namespace ticker::tasks {
namespace {

/// Never answers, and ends in a given way.
class Silent final : public probe::Examinee {
public:
    explicit Silent(probe::ProcessEnd::Kind kind) : kind_(kind) {}
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        probe::Run run;
        run.end = {kind_, "signal 11"};
        for (const probe::Question& question : questions) {
            if (std::holds_alternative<probe::RenderQuestion>(question))
                run.answers.emplace_back(probe::RenderAnswer{});
            else
                run.answers.emplace_back(probe::IlluminateAnswer{});
        }
        return run;
    }

private:
    probe::ProcessEnd::Kind kind_;
};

TEST(JudgeDistributed, BlocksBothTasksWhenTheProgramCrashes) {
    Silent examinee{probe::ProcessEnd::Kind::crashed};
    const DistributedJudgement judgement = judgeDistributed(examinee, {}, 1);
    EXPECT_EQ(judgement.softShadows.state, TaskState::blocked);
    ASSERT_EQ(judgement.depthOfField.findings.size(), 1U);
    EXPECT_EQ(judgement.depthOfField.findings[0].id, "run.crashed");
}

TEST(JudgeDistributed, NeverGradesWhatCouldNotBeRun) {
    Silent examinee{probe::ProcessEnd::Kind::ourFault};
    const DistributedJudgement judgement = judgeDistributed(examinee, {}, 1);
    EXPECT_EQ(judgement.softShadows.state, TaskState::notGraded);
    EXPECT_EQ(judgement.depthOfField.state, TaskState::notGraded);
}

TEST(JudgeDistributed, JudgesOnlyWhatWasAttempted) {
    Silent examinee{probe::ProcessEnd::Kind::timedOut};
    const DistributedJudgement judgement =
        judgeDistributed(examinee, {.softShadows = true, .depthOfField = false}, 1);
    ASSERT_FALSE(judgement.softShadows.findings.empty());
    EXPECT_EQ(judgement.softShadows.findings[0].id, "run.timed-out");
    EXPECT_EQ(judgement.depthOfField.state, TaskState::notAttempted);
}

}  // namespace
}  // namespace ticker::tasks
