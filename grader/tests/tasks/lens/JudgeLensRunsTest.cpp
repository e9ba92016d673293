// T2.2 judged from whole runs: the reference, and mistakes that only a later question shows.
#include <grader/tasks/lens/JudgeLens.h>
#include <grader/tasks/lens/answers/LensThreads.h>
#include <grader/tasks/lens/questions/LensQuestions.h>
#include <grader/tests/support/LocalExaminee.h>
#include <grader/tests/tasks/support/AlteredExaminee.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ticker::tasks {
namespace {

/// The reference, but from its second run on, the second picture of a run of two has one ray for
/// each pixel.
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

/// The reference for the first `rightScenes` different scenes. All later scenes get another focal
/// plane, in every run and whatever their settings are.
class SceneDecides final : public probe::Examinee {
public:
    explicit SceneDecides(std::size_t rightScenes) : rightScenes_(rightScenes) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        std::vector<probe::Question> altered = questions;
        for (probe::Question& question : altered) {
            auto& asked = std::get<probe::RenderQuestion>(question);
            const probe::ColourRGB& light = asked.scene.ambientLighting;
            if (std::ranges::find(lights_, light) == lights_.end()) lights_.push_back(light);
            const auto place = std::ranges::find(lights_, light) - lights_.begin();
            if (static_cast<std::size_t>(place) >= rightScenes_)
                asked.settings.dofFocalPlane *= 1.2;
        }
        return reference_.ask(altered);
    }

private:
    tests::LocalExaminee reference_;
    std::size_t rightScenes_;
    std::vector<probe::ColourRGB> lights_;
};

std::string idsOf(const TaskJudgement& judgement) {
    std::string ids;
    for (const Finding& finding : judgement.findings)
        ids += finding.id + " ";
    return ids;
}

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
    ASSERT_EQ(idsOf(judgement), "dof.wrong ");
    EXPECT_NE(judgement.findings[0].message.find("keeps something of the first"),
              std::string::npos);
}

// The questions in the order of their scenes: the handout's settings, other settings, two threads,
// the picture before, and the next one.
TEST(JudgeLens, AccusesNeitherThreadsNorSettingsNorMemoryWhereTheSceneDecides) {
    for (const std::size_t rightScenes : {1U, 2U, 4U}) {
        SceneDecides examinee{rightScenes};
        const TaskJudgement judgement = judgeLens(examinee, 2);
        EXPECT_EQ(judgement.state, TaskState::failed) << rightScenes;
        EXPECT_FALSE(judgement.needsReview);
        ASSERT_EQ(idsOf(judgement), "dof.focal-plane ") << rightScenes;
        EXPECT_NE(judgement.findings[0].hint.find("what the scene shows"), std::string::npos);
    }
}

/// The reference; the rays of every second pixel are not visible.
class HalfSeen final : public probe::Examinee {
public:
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        probe::Run run = reference_.ask(questions);
        for (probe::Answer& answer : run.answers) {
            bool isHidden = false;
            std::erase_if(std::get<probe::RenderAnswer>(answer).events,
                          [&](const probe::Event& event) {
                              if (event.kind == probe::Event::Kind::cameraRayAsked)
                                  isHidden = event.x % 2 == 1;
                              return isHidden;
                          });
        }
        return run;
    }

private:
    tests::LocalExaminee reference_;
};

TEST(JudgeLens, SaysThatTheRaysOfSomePixelsWereSeen) {
    HalfSeen examinee;
    const TaskJudgement judgement = judgeLens(examinee, 2);
    EXPECT_EQ(judgement.state, TaskState::passed);
    ASSERT_EQ(idsOf(judgement), "dof.unseen-rays ");
    EXPECT_NE(judgement.findings[0].message.find("the rays of some pixels"), std::string::npos)
        << judgement.findings[0].message;
}

/// A picture of one thread as if two had drawn it, one after the other.
void drawnInTurn(probe::RenderAnswer& answer) {
    const std::size_t half = answer.images.at(0).size() / 2;
    std::size_t pixels = 0;
    for (probe::Event& event : answer.events) {
        event.thread = pixels < half ? 0 : 1;
        if (event.kind == probe::Event::Kind::pixelSet) ++pixels;
    }
}

/// As if two threads had drawn the picture, each of them every other pixel. The first one sets its
/// pixel after the second one has set the next.
void drawnTogether(probe::RenderAnswer& answer) {
    int pixels = 0;
    auto lastSet = answer.events.begin();
    for (auto event = answer.events.begin(); event != answer.events.end(); ++event) {
        event->thread = static_cast<std::uint16_t>(pixels % 2);
        if (event->kind != probe::Event::Kind::pixelSet) continue;
        if (++pixels % 2 == 0) std::rotate(lastSet, lastSet + 1, event + 1);
        lastSet = event;
    }
}

probe::RenderAnswer threadsPicture() {
    tests::LocalExaminee reference;
    AlteredExaminee alone{reference, [](auto& settings) { settings.threads = 1; }};
    return std::get<probe::RenderAnswer>(alone.ask({drawThreadsQuestion(2)}).answers.at(0));
}

TEST(ThreadsMet, CountsHowOftenAThreadWasInterruptedInThePixelThatItDraws) {
    probe::RenderAnswer answer = threadsPicture();
    EXPECT_FALSE(threadsMet(answer.events).several);
    drawnInTurn(answer);
    EXPECT_TRUE(threadsMet(answer.events).several);
    EXPECT_EQ(threadsMet(answer.events).interrupted, 0U);
    answer = threadsPicture();
    drawnTogether(answer);
    EXPECT_EQ(threadsMet(answer.events).interrupted, answer.images.at(0).size() / 2);
}

/// The reference. With two threads its pictures are too bright, but only if its threads interrupt
/// each other, which they do from a certain question on.
class RacesLate final : public probe::Examinee {
public:
    explicit RacesLate(int inTurn) : inTurn_(inTurn) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        AlteredExaminee alone{reference_, [](auto& settings) { settings.threads = 1; }};
        probe::Run run = alone.ask(questions);
        for (std::size_t i = 0; i < questions.size(); ++i)
            if (std::get<probe::RenderQuestion>(questions[i]).settings.threads > 1)
                drawWithTwo(std::get<probe::RenderAnswer>(run.answers[i]));
        return run;
    }
    [[nodiscard]] int asked() const { return asked_; }

private:
    void drawWithTwo(probe::RenderAnswer& answer) {
        if (asked_++ < inTurn_) return drawnInTurn(answer);
        drawnTogether(answer);
        for (probe::ColourRGB& colour : answer.images.at(0))
            colour = colour * 1.1;
    }

    tests::LocalExaminee reference_;
    int inTurn_;
    int asked_ = 0;
};

// On a busy machine a thread may draw its half of the picture while the other one waits.
TEST(JudgeLens, AsksAgainUntilThreadsInterruptEachOther) {
    RacesLate busy{3};
    EXPECT_EQ(idsOf(judgeLens(busy, 2)), "dof.threads-mixed ");
}

// Code that lets only one thread at a time draw a pixel is right.
TEST(JudgeLens, PassesThreadsThatNeverInterruptEachOther) {
    RacesLate never{1000};
    const TaskJudgement judgement = judgeLens(never, 2);
    EXPECT_EQ(judgement.state, TaskState::passed);
    EXPECT_TRUE(judgement.findings.empty());
    EXPECT_EQ(never.asked(), 8);
}

TEST(JudgeLens, AccusesThreadsAndSettingsThatAreAtFault) {
    tests::LocalExaminee reference;
    AlteredExaminee threads{reference, [](auto& settings) {
                                if (settings.threads > 1) settings.dofFocalPlane *= 1.2;
                            }};
    EXPECT_EQ(idsOf(judgeLens(threads, 2)), "dof.threads-mixed ");
    AlteredExaminee hardCoded{reference, [](auto& settings) { settings.dofAmount = 0.2; }};
    const TaskJudgement warned = judgeLens(hardCoded, 2);
    EXPECT_EQ(warned.state, TaskState::passed);
    EXPECT_EQ(idsOf(warned), "settings.hard-coded ");
}

}  // namespace
}  // namespace ticker::tasks
