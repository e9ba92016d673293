// What cannot be seen is judged by statistics in two stages: a failure counts where it comes again.
#include <grader/decision/distributed/JudgeDistributed.h>
#include <grader/selftest/AlteredExaminee.h>
#include <grader/tests/support/LocalExaminee.h>

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace ticker::decision {
namespace {

using raytracer::RenderSettings;

enum class Stage { right, wrong, silent };

/// The reference with hidden rays, whose light is too small where told; the first sitting is right.
class Staged final : public probe::Examinee {
public:
    explicit Staged(std::vector<Stage> stages) : stages_(std::move(stages)) {}

    [[nodiscard]] probe::Sitting ask(const std::vector<probe::Question>& questions) override {
        const Stage stage = sittings_ == 0 ? Stage::right : stages_.at(sittings_ - 1);
        ++sittings_;
        if (stage == Stage::silent) return {{probe::IlluminateAnswer{}}, {}};
        selftest::AlteredExaminee hidden{reference_,
                                         [=](RenderSettings& settings) {
                                             if (stage == Stage::wrong) settings.lightSize *= 0.7;
                                         },
                                         true};
        return hidden.ask(questions);
    }
    [[nodiscard]] std::size_t stages() const { return sittings_ - 1; }

private:
    tests::LocalExaminee reference_;
    std::vector<Stage> stages_;
    std::size_t sittings_ = 0;
};

struct Said {
    TaskState state;
    bool needsReview;
    std::size_t stages;
};

Said judge(std::vector<Stage> stages) {
    Staged examinee{std::move(stages)};
    const TaskJudgement judgement =
        judgeDistributed(examinee, {.softShadows = true, .depthOfField = false}, 4).softShadows;
    return {judgement.state, judgement.needsReview, examinee.stages()};
}

// Each right stage is refused with a chance below 1e-7.
TEST(Stages, FailWhatIsWrongTwiceAndAskAPersonWhereItIsWrongOnce) {
    const Said right = judge({Stage::right});
    EXPECT_EQ(right.state, TaskState::passed);
    EXPECT_FALSE(right.needsReview);
    EXPECT_EQ(right.stages, 1U);
    const Said once = judge({Stage::wrong, Stage::right});
    EXPECT_EQ(once.state, TaskState::passed);
    EXPECT_TRUE(once.needsReview);
    const Said twice = judge({Stage::wrong, Stage::wrong});
    EXPECT_EQ(twice.state, TaskState::failed);
    EXPECT_FALSE(twice.needsReview) << "it is decided";
}

TEST(Stages, AskAPersonWhereNoAnswerComes) {
    for (const std::vector<Stage>& stages :
         {std::vector{Stage::silent}, std::vector{Stage::wrong, Stage::silent}}) {
        const Said said = judge(stages);
        EXPECT_EQ(said.state, TaskState::passed);
        EXPECT_TRUE(said.needsReview);
        EXPECT_EQ(said.stages, stages.size());
    }
}

}  // namespace
}  // namespace ticker::decision
