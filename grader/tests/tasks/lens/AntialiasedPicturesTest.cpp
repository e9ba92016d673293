// Antialiased pictures: their rays go through the whole pixel, or a part of it. The rays themselves
// are not visible.
#include <grader/tasks/lens/JudgeLens.h>
#include <grader/tasks/lens/checks/PictureCheck.h>
#include <grader/tasks/lens/questions/PictureQuestions.h>
#include <grader/tests/tasks/lens/OraclePictures.h>
#include <grader/tests/tasks/support/InFinding.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ticker::tasks {
namespace {

using oracle::Mistake;
using oracle::Reading;

Reading antialiasing(double spread, double factor = 1.0) {
    Reading reading;
    reading.pixelSpread = spread;
    reading.apertureFactor = factor;
    return reading;
}

PictureVerdict verdictOn(const Reading& reading, const Mistake& mistake, std::uint64_t seed,
                         bool onePicture = false) {
    const probe::RenderQuestion asked = drawPictureQuestion(seed, onePicture);
    return judgePictures(asked, answerOf(asked, seed + 1, mistake, reading), seed);
}

// A right picture fails with a chance below 3e-7.
TEST(AntialiasedPictures, AreAcceptedWithEitherApertureInAllOrAPartOfThePixel) {
    struct Case {
        double spread;
        double factor;
        bool onePicture;
    };
    for (const Case& one : {Case{1.0, 1.0, false}, Case{1.0, 0.5, true}, Case{0.82, 1.0, true},
                            Case{0.65, 0.5, false}}) {
        const PictureVerdict verdict =
            verdictOn(antialiasing(one.spread, one.factor), {}, 3, one.onePicture);
        EXPECT_EQ(idOf(verdict.finding), "") << one.factor;
        EXPECT_FALSE(verdict.ambiguous);
        // The noise of one picture may hide that a part of the pixel is used.
        if (!one.onePicture || one.spread == 1.0) {
            EXPECT_NEAR(verdict.reading.pixelSpread, one.spread, one.onePicture ? 0.2 : 0.1);
        }
        EXPECT_EQ(verdict.reading.apertureFactor, one.factor);
        if (!one.onePicture || one.spread == 1.0) {
            EXPECT_LT(verdict.timesTheLimit, one.spread == 1.0 ? 0.8 : 1.0);
        }
    }
}

// The noise of a single picture may hide antialiasing. Its blur then looks like that of a mistake.
TEST(AntialiasedPictures, AreNotFailedForASinglePicture) {
    for (const std::uint64_t seed : {105U, 109U, 110U})
        EXPECT_EQ(idOf(verdictOn(antialiasing(0.7), {}, seed, true).finding), "") << seed;
}

TEST(AntialiasedPictures, AreNoExcuseForAFocalPlaneThatIsOffInASinglePicture) {
    Mistake plane;
    plane.focalFactor = 0.95;
    for (const std::uint64_t seed : {103U, 109U})
        EXPECT_EQ(idOf(verdictOn({}, plane, seed, true).finding), "dof.focal-distance") << seed;
}

// The search finds the square to a quarter of its first step. That leaves room for the noise, whose
// z exceeds 4.5 with a chance below 1e-4 in each picture.
TEST(AntialiasedPictures, LeaveRoomBetweenTwoSizesOfTheSearch) {
    for (const double spread : {0.55, 0.65, 0.74}) {
        const PictureVerdict verdict = verdictOn(antialiasing(spread, 0.5), {}, 12);
        EXPECT_LT(verdict.timesTheLimit, 0.75) << spread;
        EXPECT_NEAR(verdict.reading.pixelSpread, spread, 0.045);
    }
}

TEST(JudgePictures, ReadsAPixelSpreadOfZeroWithoutAntialiasing) {
    EXPECT_EQ(verdictOn({}, {}, 4).reading.pixelSpread, 0.0);
}

Mistake with(void (*change)(Mistake&)) {
    Mistake mistake;
    change(mistake);
    return mistake;
}

struct NamedMistake {
    std::string id;
    Mistake mistake;
};

std::vector<NamedMistake> mistakes() {
    return {{"dof.disc", with([](Mistake& m) { m.aperture = Mistake::Aperture::disc; })},
            {"dof.focal-distance", with([](Mistake& m) { m.focalByDistance = true; })},
            {"dof.focal-plane", with([](Mistake& m) { m.focalFactor = 1.2; })},
            {"dof.off-centre", with([](Mistake& m) { m.lensOffsetX = m.lensOffsetY = 1.0; })},
            {"dof.not-averaged", with([](Mistake& m) { m.pixelScale = 50.0; })}};
}

TEST(AntialiasedPictures, FailByTheNameOfTheirMistake) {
    for (const NamedMistake& one : mistakes()) {
        const PictureVerdict verdict = verdictOn(antialiasing(1.0), one.mistake, 6);
        EXPECT_EQ(idOf(verdict.finding), one.id);
        EXPECT_FALSE(verdict.ambiguous);
    }
}

// Mistakes that blur a little more or less than they should.
TEST(AntialiasedPictures, AreNotWhatSmallMistakesShow) {
    Mistake plane;
    plane.focalFactor = 0.97;
    EXPECT_TRUE(verdictOn({}, plane, 8).finding);
    Reading aperture;
    aperture.apertureFactor = 1.1;
    EXPECT_TRUE(verdictOn(aperture, {}, 8).finding);
}

/// Code without visible rays, whose pictures the oracle draws.
class UnseenStudent final : public probe::Examinee {
public:
    UnseenStudent(const Reading& reading, const Mistake& mistake)
        : reading_(reading), mistake_(mistake) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        probe::Run run;
        for (const probe::Question& question : questions)
            run.answers.emplace_back(answerOf(std::get<probe::RenderQuestion>(question),
                                              ++answered_, mistake_, reading_));
        return run;
    }

private:
    Reading reading_;
    Mistake mistake_;
    std::uint64_t answered_ = 0;
};

std::string idsOf(const TaskJudgement& judgement) {
    std::string ids;
    for (const Finding& finding : judgement.findings)
        ids += finding.id + " ";
    return ids;
}

TEST(JudgeLens, WarnsOfAntialiasingThatOnlyPicturesShow) {
    UnseenStudent student{antialiasing(1.0, 0.5), {}};
    const TaskJudgement judgement = judgeLens(student, 2);
    EXPECT_EQ(judgement.state, TaskState::passed);
    EXPECT_FALSE(judgement.needsReview);
    EXPECT_EQ(judgement.apertureFactor, 0.5);
    ASSERT_EQ(idsOf(judgement), "dof.antialiased dof.unseen-rays ");
    EXPECT_NE(judgement.findings[0].message.find("the pictures are those"), std::string::npos);
}

/// Code without visible rays, whose focal points are off by up to 0.05 world units, however large
/// a pixel is.
class JitteredStudent final : public probe::Examinee {
public:
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        const auto& settings = std::get<probe::RenderQuestion>(questions.at(0)).settings;
        const double pixel =
            2.0 * std::tan(std::numbers::pi / 8.0) / settings.width * settings.dofFocalPlane;
        UnseenStudent student{antialiasing(0.1 / pixel), {}};
        return student.ask(questions);
    }
};

TEST(JudgeLens, FailsFocalPointsThatAreOffByALengthOfTheirOwn) {
    const probe::RenderQuestion asked = drawPictureQuestion(9);
    JitteredStudent student;
    const auto answer = std::get<probe::RenderAnswer>(student.ask({asked}).answers.at(0));
    EXPECT_FALSE(judgePictures(asked, answer, 9).finding) << "the pixels hide it at this size";
    const TaskJudgement judgement = judgeLens(student, 2);
    EXPECT_EQ(judgement.state, TaskState::failed);
    EXPECT_EQ(idsOf(judgement), "dof.focal-plane dof.unseen-rays ");
}

TEST(JudgeFinePictures, WantTheReadingOfTheLargePixelsAndNoMistake) {
    constexpr std::uint64_t kSeed = 9;
    const probe::RenderQuestion asked = drawFinePictureQuestion(kSeed);
    Expectations expectations{asked, kSeed};
    const Reading reading = antialiasing(1.0);
    const auto right = answerOf(asked, kSeed + 1, {}, reading);
    EXPECT_FALSE(judgeFinePictures(expectations, right, reading).finding);
    const auto mistaken = answerOf(asked, kSeed + 1, mistakes()[0].mistake, reading);
    EXPECT_TRUE(judgeFinePictures(expectations, mistaken, reading).finding);
}

TEST(JudgeLens, FailsAMistakeBesideAntialiasingWithoutWarningOfThat) {
    UnseenStudent student{antialiasing(1.0), mistakes()[0].mistake};
    const TaskJudgement judgement = judgeLens(student, 2);
    EXPECT_EQ(judgement.state, TaskState::failed);
    EXPECT_EQ(idsOf(judgement), "dof.disc dof.unseen-rays ");
}

TEST(JudgeLensOfMany, JudgesAsTheJudgeOfOneDoes) {
    const Judge ofMany = judgeLensOfMany();
    for (const Reading& reading : {antialiasing(1.0, 0.5), Reading{}}) {
        UnseenStudent one{reading, {}};
        UnseenStudent same{reading, {}};
        EXPECT_EQ(idsOf(ofMany(one, 2)), idsOf(judgeLens(same, 2)));
    }
}

}  // namespace
}  // namespace ticker::tasks
