#include <grader/tasks/shadows/ScreenShadows.h>
#include <grader/tasks/shadows/questions/ShadowQuestions.h>
#include <grader/tests/support/LocalExaminee.h>
#include <grader/tests/tasks/support/AlteredExaminee.h>

#include <gtest/gtest.h>

#include <variant>
#include <vector>

namespace ticker::tasks {
namespace {

using probe::IlluminateAnswer;
using raytracer::RenderSettings;

constexpr std::uint64_t kSeed = 3;

bool mayPassWith(const AlteredExaminee::Alter& alter, bool hideRays = false) {
    tests::LocalExaminee reference;
    AlteredExaminee examinee{reference, alter, hideRays};
    const Screening screening = screenShadows(kSeed);
    return screening.mayPass(examinee.ask(screening.questions));
}

TEST(ScreenShadows, LetsRightShadowsPassAndStopsWhatOneLightShows) {
    EXPECT_TRUE(mayPassWith({}));
    EXPECT_FALSE(mayPassWith([](RenderSettings& s) { s.shadowRayCount = 1; }));
    EXPECT_FALSE(mayPassWith([](RenderSettings& s) { s.shadowRayCount = 9; }));
    EXPECT_FALSE(mayPassWith({}, true)) << "hidden rays take too long";
}

TEST(ScreenShadows, AsksWithOneLightWithSeveralAndWithObjectsBeyond) {
    using Purpose = ShadowQuestion::Purpose;
    std::vector<std::size_t> lights;
    for (const ShadowQuestion& question : drawShadowQuestions(kSeed))
        if (question.purpose == Purpose::oneLight || question.purpose == Purpose::severalLights ||
            question.purpose == Purpose::beyondLight)
            lights.push_back(question.question.scene.pointLights.size());
    std::vector<std::size_t> asked;
    for (const probe::Question& question : screenShadows(kSeed).questions)
        asked.push_back(std::get<probe::IlluminateQuestion>(question).scene.pointLights.size());
    EXPECT_EQ(asked, lights);
}

TEST(ScreenShadows, StopsChangedColoursAndMissingAnswersOfAnyQuestion) {
    tests::LocalExaminee reference;
    const Screening screening = screenShadows(kSeed);
    const probe::Run right = reference.ask(screening.questions);
    for (std::size_t i = 0; i < right.answers.size(); ++i) {
        probe::Run tinted = right;
        for (probe::ColourRGB& colour : std::get<IlluminateAnswer>(tinted.answers[i]).colours)
            colour.g += 0.3;
        EXPECT_FALSE(screening.mayPass(tinted)) << i;
        probe::Run threw = right;
        std::get<IlluminateAnswer>(threw.answers[i]).state = probe::AnswerState::threw;
        EXPECT_FALSE(screening.mayPass(threw)) << i;
        probe::Run other = right;
        other.answers[i] = probe::RenderAnswer{};
        EXPECT_FALSE(screening.mayPass(other)) << i;
    }
    probe::Run cut = right;
    cut.answers.pop_back();
    EXPECT_TRUE(screening.mayPass(cut)) << "what was not asked decides nothing";
}

}  // namespace
}  // namespace ticker::tasks
