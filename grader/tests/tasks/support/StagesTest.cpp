// Code whose rays are not visible is judged by statistics in two stages: only a repeated failure
// counts.
#include <grader/tasks/shadows/JudgeShadows.h>
#include <grader/tests/support/LocalExaminee.h>
#include <grader/tests/tasks/support/AlteredExaminee.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace ticker::tasks {
namespace {

using raytracer::RenderSettings;

enum class Turn { right, wrong, silent };

enum class Rays { hidden, beyondTheLog };

/// The reference. The first run is right; in later ones the light is right, too small, or there is
/// no answer, as `stages` says.
class Staged final : public probe::Examinee {
public:
    Staged(std::vector<Turn> stages, Rays rays) : stages_(std::move(stages)), rays_(rays) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        if (std::holds_alternative<probe::RenderQuestion>(questions.front()))
            return reference_.ask(questions);
        const Turn turn = runs_ == 0 ? Turn::right : stages_.at(runs_ - 1);
        ++runs_;
        if (turn == Turn::silent) return {{probe::IlluminateAnswer{}}, {}};
        AlteredExaminee hidden{reference_,
                               [=](RenderSettings& settings) {
                                   if (turn == Turn::wrong) settings.lightSize *= 0.7;
                               },
                               rays_ == Rays::hidden};
        probe::Run run = hidden.ask(questions);
        for (probe::Answer& answer : run.answers)
            std::get<probe::IlluminateAnswer>(answer).eventsCut = rays_ == Rays::beyondTheLog;
        return run;
    }
    [[nodiscard]] std::size_t stages() const { return runs_ - 1; }

private:
    tests::LocalExaminee reference_;
    std::vector<Turn> stages_;
    Rays rays_;
    std::size_t runs_ = 0;
};

struct Said {
    TaskState state;
    bool needsReview;
    std::size_t stages;
    std::size_t warnings;
};

Said judge(std::vector<Turn> stages, Rays rays = Rays::hidden) {
    Staged examinee{std::move(stages), rays};
    const TaskJudgement judgement = judgeShadows(examinee, 4);
    const auto warnings =
        std::ranges::count(judgement.findings, Severity::warn, &Finding::severity);
    return {judgement.state, judgement.needsReview, examinee.stages(),
            static_cast<std::size_t>(warnings)};
}

// Each right stage is refused with a chance below 1e-7.
TEST(Stages, FailWhatIsWrongTwiceAndAskAPersonWhereItIsWrongOnce) {
    const Said right = judge({Turn::right});
    EXPECT_EQ(right.state, TaskState::passed);
    EXPECT_FALSE(right.needsReview);
    EXPECT_EQ(right.stages, 1U);
    const Said once = judge({Turn::wrong, Turn::right});
    EXPECT_EQ(once.state, TaskState::passed);
    EXPECT_TRUE(once.needsReview);
    EXPECT_EQ(once.warnings, 1U) << "the person is told why";
    const Said twice = judge({Turn::wrong, Turn::wrong});
    EXPECT_EQ(twice.state, TaskState::failed);
    EXPECT_FALSE(twice.needsReview) << "it is decided";
}

TEST(Stages, AskAPersonWhereNoAnswerComes) {
    for (const std::vector<Turn>& stages :
         {std::vector{Turn::silent}, std::vector{Turn::wrong, Turn::silent}}) {
        const Said said = judge(stages);
        EXPECT_EQ(said.state, TaskState::passed);
        EXPECT_TRUE(said.needsReview);
        EXPECT_EQ(said.stages, stages.size());
        EXPECT_EQ(said.warnings, 1U);
    }
}

// Rays beyond the log's capacity are judged by their results.
TEST(Stages, JudgeTheResultsOfRaysThatTheLogHadNoRoomFor) {
    EXPECT_EQ(judge({Turn::right}, Rays::beyondTheLog).state, TaskState::passed);
    EXPECT_EQ(judge({Turn::wrong, Turn::wrong}, Rays::beyondTheLog).state, TaskState::failed);
}

}  // namespace
}  // namespace ticker::tasks
