#include <grader/tasks/lens/JudgeLens.h>
#include <grader/tasks/shadows/JudgeShadows.h>

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

TEST(JudgeBoth, AreBlockedWhenTheProgramCrashes) {
    Silent examinee{probe::ProcessEnd::Kind::crashed};
    EXPECT_EQ(judgeShadows(examinee, 1).state, TaskState::blocked);
    const TaskJudgement lens = judgeLens(examinee, 1);
    ASSERT_EQ(lens.findings.size(), 1U);
    EXPECT_EQ(lens.findings[0].id, "run.crashed");
}

TEST(JudgeBoth, NeverGradeWhatCouldNotBeRun) {
    Silent examinee{probe::ProcessEnd::Kind::ourFault};
    EXPECT_EQ(judgeShadows(examinee, 1).state, TaskState::notGraded);
    EXPECT_EQ(judgeLens(examinee, 1).state, TaskState::notGraded);
}

TEST(JudgeBoth, SayThatTimeWasUp) {
    Silent examinee{probe::ProcessEnd::Kind::timedOut};
    const TaskJudgement shadows = judgeShadows(examinee, 1);
    ASSERT_FALSE(shadows.findings.empty());
    EXPECT_EQ(shadows.findings[0].id, "run.timed-out");
}

}  // namespace
}  // namespace ticker::tasks
