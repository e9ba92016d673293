// Normals that are right alone and wrong where two threads ask for them.
#include <grader/lab/selftest/BumpModel.h>
#include <grader/tasks/bump/BumpThreads.h>
#include <grader/tasks/bump/JudgeBump.h>
#include <grader/tests/tasks/bump/Judging.h>

#include <gtest/gtest.h>

#include <limits>
#include <variant>

namespace ticker::tasks {
namespace {

using probe::RenderAnswer;
using probe::RenderQuestion;
using raytracer::ColourRGB;

/// Right normals, and renders of one grey, `first`. With two threads one pixel of the last picture
/// is `second`.
class Racing final : public probe::Examinee {
public:
    Racing(double second, std::size_t pictures, double first = 0.25)
        : first_(first), second_(second), pictures_(pictures) {}

    probe::Run ask(const std::vector<probe::Question>& questions) override {
        probe::Run run = normals_.ask(questions);
        for (std::size_t i = 0; i < questions.size(); ++i) {
            const auto* asked = std::get_if<RenderQuestion>(&questions[i]);
            if (asked == nullptr) continue;
            RenderAnswer answer;
            answer.state = probe::AnswerState::answered;
            const auto pixels = static_cast<std::size_t>(asked->settings.width) *
                                static_cast<std::size_t>(asked->settings.height);
            answer.images.assign(pictures_, std::vector<ColourRGB>(pixels, ColourRGB{first_}));
            if (asked->settings.threads == 2) answer.images.back().at(17) = ColourRGB{second_};
            run.answers[i] = answer;
        }
        return run;
    }

private:
    selftest::FunctionExaminee normals_{[](const selftest::Point& point) {
        return modelNormal({}, selftest::Mistake::none, point);
    }};
    double first_;
    double second_;
    std::size_t pictures_;
};

TEST(BumpThreads, FailWhereTwoThreadsRenderAnotherPictureThanOne) {
    Racing racing{0.5, 3};
    const TaskJudgement judgement = judgeBump(racing, 3);
    EXPECT_EQ(judgement.state, TaskState::failed);
    EXPECT_EQ(tests::firstId(judgement), "bump.threads-mixed");
    EXPECT_NE(judgement.reason.find(": 1 pixels differ"), std::string::npos) << judgement.reason;
}

TEST(BumpThreads, PassWhereBothRenderTheSameOrAPictureIsMissing) {
    Racing same{0.25, 3};
    EXPECT_EQ(judgeBump(same, 3).state, TaskState::passed);
    Racing shortOfOne{0.5, 2};
    EXPECT_EQ(judgeBump(shortOfOne, 3).state, TaskState::passed);
}

TEST(BumpThreads, TakeTheSameNaNInBothForTheSame) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    Racing same{kNaN, 3, kNaN};
    EXPECT_EQ(judgeBump(same, 3).state, TaskState::passed);
    Racing once{kNaN, 3};
    EXPECT_EQ(tests::firstId(judgeBump(once, 3)), "bump.threads-mixed");
}

/// Right normals, and a crash after them.
class CrashesLater final : public probe::Examinee {
public:
    probe::Run ask(const std::vector<probe::Question>& questions) override {
        probe::Run run = selftest::FunctionExaminee{[](const selftest::Point& point) {
                             return modelNormal({}, selftest::Mistake::none, point);
                         }}.ask(questions);
        run.end = {probe::ProcessEnd::Kind::crashed, "signal 11"};
        return run;
    }
};

TEST(BumpThreads, SayThatTheProgramCrashedInTheRenders) {
    CrashesLater crashing;
    const TaskJudgement judgement = judgeBump(crashing, 3);
    EXPECT_EQ(judgement.state, TaskState::blocked);
    EXPECT_EQ(tests::firstId(judgement), "run.crashed");
    EXPECT_NE(judgement.reason.find("with one thread and with two"), std::string::npos)
        << judgement.reason;
}

TEST(BumpThreads, AskForTheSamePictureWithOneThreadAndWithTwo) {
    const auto asked = bump::drawThreadedRenders(4);
    ASSERT_EQ(asked.size(), 4U);
    for (const std::size_t pair : {0U, 2U}) {
        const auto& alone = std::get<RenderQuestion>(asked[pair]);
        const auto& together = std::get<RenderQuestion>(asked[pair + 1]);
        EXPECT_EQ(alone.settings.threads, 1);
        EXPECT_EQ(together.settings.threads, 2);
        EXPECT_EQ(alone.scene.spheres.size(), 4U);
        for (const auto& sphere : alone.scene.spheres)
            EXPECT_NE(sphere.heightMap, nullptr);
    }
}

// Slopes that are kept for one map are computed anew inside of nearly every pixel of a mirror,
// which takes longer than all else. Without a log nothing makes threads take turns between pixels.
TEST(BumpThreads, AskForMirrorsOfLargeMapsAlsoWithoutALog) {
    const auto asked = bump::drawThreadedRenders(4);
    ASSERT_EQ(asked.size(), 4U);
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const auto& render = std::get<RenderQuestion>(asked[i]);
        EXPECT_EQ(render.eventCapacity > 0, i < 2) << i;
        EXPECT_GE(render.settings.bounces, 1);
        EXPECT_GT(render.scene.spheres.front().material.reflectivity, 0.0);
        for (const auto& sphere : render.scene.spheres)
            EXPECT_GE(sphere.heightMap->width() * sphere.heightMap->height(), 8192);
    }
}

}  // namespace
}  // namespace ticker::tasks
