#include <grader/lab/selftest/OracleExaminee.h>
#include <grader/lab/selftest/PictureTricks.h>
#include <grader/lab/selftest/ScreenshotStudent.h>
#include <grader/metrics/Alignment.h>
#include <grader/probe/Wire.h>
#include <grader/tasks/screenshot/JudgeScreenshot.h>
#include <grader/tasks/screenshot/Windows.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace ticker::selftest {
namespace {

using metrics::ByteView;
using pipeline::SpecScene;

constexpr std::uint64_t kSeed = 11;

const std::vector<SpecScene>& scenes() {
    static const std::vector<SpecScene> read =
        pipeline::readSpecScenes(std::filesystem::path{TICKER_SOURCE_DIR} / "scenes",
                                 std::filesystem::path{TICKER_SOURCE_DIR} / "assets");
    return read;
}

/// A student of either option whose code is the oracle with the handout's reading.
class Honest {
public:
    explicit Honest(bool isDeterministic)
        : code_({}, {}, isDeterministic), student_(scenes(), isDeterministic, code_) {}
    const ScreenshotStudent* operator->() const { return &student_; }

    [[nodiscard]] TaskJudgement handIn(const Picture& picture) const {
        double unused = 0.0;
        return student_.handIn(picture, kSeed, unused);
    }

private:
    OracleExaminee code_;
    ScreenshotStudent student_;
};

/// Hands all questions on, and keeps them encoded.
class Listening : public probe::Examinee {
public:
    explicit Listening(probe::Examinee& asked) : asked_(asked) {}
    probe::Run ask(const std::vector<probe::Question>& questions) override {
        heard_.push_back(probe::encodeQuestions(questions));
        return asked_.ask(questions);
    }
    void forget() { heard_.clear(); }
    [[nodiscard]] const std::vector<std::vector<std::byte>>& heard() const { return heard_; }

private:
    probe::Examinee& asked_;
    std::vector<std::vector<std::byte>> heard_;
};

std::string firstId(const TaskJudgement& judgement) {
    return judgement.findings.empty() ? "" : judgement.findings.front().id;
}

std::string evidence(const TaskJudgement& judgement, const std::string& key) {
    for (const auto& [name, value] : judgement.findings.at(0).evidence)
        if (name == key) return std::get<std::string>(value);
    return "";
}

TEST(JudgeScreenshot, PassesHonestPicturesWithoutAWord) {
    for (const bool isDeterministic : {true, false}) {
        const Honest student{isDeterministic};
        const TaskJudgement judgement = student.handIn(student->render(320, kSeed));
        EXPECT_EQ(judgement.state, TaskState::passed);
        EXPECT_TRUE(judgement.findings.empty()) << firstId(judgement);
        EXPECT_FALSE(judgement.needsReview);
    }
}

// The pipeline asks these questions ahead, in the run that draws the submission's own pictures. If
// the judge asked others, the answers of that run would go unused, and only the time would show it.
TEST(JudgeScreenshot, BeginsWithItsFirstQuestions) {
    constexpr int kWidth = 320;
    for (const bool isDeterministic : {true, false}) {
        OracleExaminee oracle{{}, {}, isDeterministic};
        Listening code{oracle};
        const ScreenshotStudent student{scenes(), isDeterministic, code};
        const Picture picture = student.render(kWidth, kSeed);
        code.forget();
        double unused = 0.0;
        (void)student.handIn(picture, kSeed, unused);
        ASSERT_FALSE(code.heard().empty());
        EXPECT_EQ(code.heard().front(),
                  probe::encodeQuestions(tasks::screenshot::firstQuestions(
                      student.scene().scene, !isDeterministic, kWidth, kWidth * 3 / 4, kSeed)));
    }
}

TEST(JudgeScreenshot, NamesTheMistakeThatAStrangersPictureShows) {
    oracle::Reading reading;
    reading.lightShape = oracle::LightShape::centre;
    OracleExaminee hard{reading, {}, false};
    const Honest student{false};
    const TaskJudgement judgement =
        student.handIn(ScreenshotStudent{scenes(), false, hard}.render(640, kSeed));
    EXPECT_EQ(judgement.state, TaskState::failed);
    EXPECT_EQ(firstId(judgement), "screenshot.not-from-this-code");
    EXPECT_EQ(evidence(judgement, "looksLike"), "shadow.hard");
    EXPECT_EQ(judgement.findings[0].rasters.size(), 1U);
}

// With fixed seeds; a radius that is off by this much has to show in small pictures, too.
TEST(JudgeScreenshot, RefusesASmallPictureOfALightOfAnotherRadius) {
    for (const double factor : {0.5, 2.0}) {
        oracle::Mistake mistake;
        mistake.lightSizeFactor = factor;
        OracleExaminee other{{}, mistake, false};
        const Honest student{false};
        const TaskJudgement judgement =
            student.handIn(ScreenshotStudent{scenes(), false, other}.render(320, kSeed));
        EXPECT_EQ(firstId(judgement), "screenshot.not-from-this-code") << factor;
    }
}

TEST(JudgeScreenshot, NamesTheReliefThatAStrangersPictureShows) {
    oracle::Reading reading;
    reading.bump.uOrigin = 0.25;
    reading.bump.gainU = -2.0;
    reading.bump.gainV = 2.0;
    OracleExaminee inverted{reading, {}, true};
    const Honest student{true};
    const TaskJudgement judgement =
        student.handIn(ScreenshotStudent{scenes(), true, inverted}.render(640, kSeed));
    EXPECT_EQ(firstId(judgement), "screenshot.not-from-this-code");
    EXPECT_EQ(evidence(judgement, "looksLike"), "bump.inverted-u");
}

/// A scene of option 1, rendered through the lens by students who have solved option 2 as well.
Picture throughTheLens(std::size_t scene) {
    OracleExaminee both{{}, {}, false};
    return ScreenshotStudent{scenes(), true, both}.render(scenes()[scene], 320, 240, kSeed);
}

TEST(JudgeScreenshot, KnowsAnotherMapThroughTheLens) {
    const Honest student{true};
    const TaskJudgement judgement = student.handIn(throughTheLens(1));
    EXPECT_EQ(firstId(judgement), "screenshot.not-this-scene");
    EXPECT_EQ(evidence(judgement, "shown"), "bumpmap-test");
}

TEST(JudgeScreenshot, BlamesNobodyWhoRenderedTheReliefThroughTheLens) {
    const Honest student{true};
    const TaskJudgement judgement = student.handIn(throughTheLens(0));
    EXPECT_EQ(judgement.state, TaskState::passed);
    EXPECT_TRUE(judgement.needsReview);
    EXPECT_EQ(firstId(judgement), "screenshot.unverified");
}

TEST(JudgeScreenshot, NamesTheNearestOfTwoScenesThatAreLikeEachOther) {
    OracleExaminee relief{{}, {}, true};
    const ScreenshotStudent other{scenes(), true, relief};
    for (const std::size_t scene : {0U, 1U}) {
        const TaskJudgement judgement =
            Honest{false}.handIn(other.render(scenes()[scene], 320, 240, kSeed));
        EXPECT_EQ(firstId(judgement), "screenshot.not-this-scene");
        EXPECT_EQ(evidence(judgement, "shown"), scenes()[scene].name);
    }
}

TEST(JudgeScreenshot, NotesASmallChangeOfColoursAndPasses) {
    const Honest student{true};
    const TaskJudgement judgement = student.handIn(
        recoloured(student->render(640, kSeed).view(), [](double v, int) { return 0.93 * v; }));
    EXPECT_EQ(judgement.state, TaskState::passed);
    EXPECT_EQ(firstId(judgement), "screenshot.colours");
    EXPECT_EQ(judgement.findings[0].severity, Severity::note);
}

// Small errors in every pixel, as in a JPEG.
TEST(JudgeScreenshot, NotesSmallErrorsEverywhereAndPasses) {
    const Honest student{true};
    Picture picture = student->render(640, kSeed);
    std::mt19937 generator{1};
    for (std::uint8_t& byte : picture.rgb)
        byte = static_cast<std::uint8_t>(byte < 10 ? byte : byte - 7 + generator() % 15);
    const TaskJudgement judgement = student.handIn(picture);
    EXPECT_EQ(judgement.state, TaskState::passed);
    EXPECT_EQ(firstId(judgement), "screenshot.resaved");
}

// Scaling and JPEG's coarse colours change every pixel of a relief, a lost row moves most pixels.
TEST(JudgeScreenshot, BlamesNobodyWhosePictureWasScaledOrLostARow) {
    const auto scaled = [](const ByteView& p) {
        return metrics::resized(p, 5 * p.width / 4, 5 * p.height / 4);
    };
    const auto trimmed = [](const ByteView& p) {
        return metrics::cropped(p, {1, 1, p.width - 2, p.height - 2});
    };
    const Honest bumpy{true};
    const Honest distributed{false};
    const Picture relief = bumpy->render(640, kSeed);
    const Picture balls = distributed->render(640, kSeed);
    for (const TaskJudgement& judgement :
         {bumpy.handIn(scaled(relief.view())), bumpy.handIn(trimmed(relief.view())),
          distributed.handIn(trimmed(balls.view()))}) {
        EXPECT_EQ(judgement.state, TaskState::passed);
        EXPECT_TRUE(judgement.needsReview);
        EXPECT_EQ(firstId(judgement), "screenshot.unverified");
    }
    EXPECT_FALSE(distributed.handIn(scaled(balls.view())).needsReview);
}

// A mouse pointer in a picture of the screen, outside of all windows.
TEST(JudgeScreenshot, CallsASmallThingInTheWayAnEdit) {
    const Honest student{true};
    Picture picture = student->render(640, kSeed);
    for (std::size_t y = 150; y < 170; ++y)
        for (std::size_t x = 0; x < 3 * 16; ++x)
            picture.rgb[3 * (640 * y + 200) + x] = 255;
    EXPECT_EQ(firstId(student.handIn(picture)), "screenshot.edited");
}

TEST(JudgeScreenshot, SaysThatThePictureIsOneOfTheOldKitsWhereItLiesOnePixelLow) {
    const Honest student{true};
    const TaskJudgement judgement = student.handIn(moved(student->render(640, kSeed).view(), 0, 1));
    EXPECT_EQ(firstId(judgement), "screenshot.edited");
    EXPECT_NE(judgement.findings[0].message.find("Java"), std::string::npos);
}

/// Ignores regions, as loops over settings().width do: `Image::set` throws.
class WholeFramesOnly final : public probe::Examinee {
public:
    explicit WholeFramesOnly(probe::Examinee& inner) : inner_(inner) {}
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        probe::Run run = inner_.ask(questions);
        for (std::size_t i = 0; i < questions.size(); ++i)
            if (!std::get<probe::RenderQuestion>(questions[i]).settings.region.isWholeFrame())
                std::get<probe::RenderAnswer>(run.answers[i]).state = probe::AnswerState::threw;
        return run;
    }

private:
    probe::Examinee& inner_;
};

TEST(JudgeScreenshot, PassesCodeThatRendersWholeFramesOnlyWithANote) {
    OracleExaminee inner{{}, {}, false};
    WholeFramesOnly code{inner};
    const ScreenshotStudent student{scenes(), false, code};
    double unused = 0.0;
    const TaskJudgement judgement = student.handIn(student.render(320, kSeed), kSeed, unused);
    EXPECT_EQ(judgement.state, TaskState::passed);
    EXPECT_EQ(firstId(judgement), "screenshot.unverified");
    EXPECT_FALSE(judgement.needsReview);
}

/// The sandbox finds no memory on the machine when it is asked for parts of the frame.
class Unstartable final : public probe::Examinee {
public:
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        const auto& first = std::get<probe::RenderQuestion>(questions.front());
        if (first.settings.region.isWholeFrame())
            return OracleExaminee{{}, {}, false}.ask(questions);
        return {std::vector<probe::Answer>(questions.size(), probe::RenderAnswer{}),
                {probe::ProcessEnd::Kind::ourFault, "no memory for the sandbox"}};
    }
};

TEST(JudgeScreenshot, SaysNothingAboutThePictureWhereWeFailed) {
    Unstartable code;
    const ScreenshotStudent student{scenes(), false, code};
    double unused = 0.0;
    const TaskJudgement judgement = student.handIn(student.render(320, kSeed), kSeed, unused);
    EXPECT_EQ(judgement.state, TaskState::notGraded);
    EXPECT_EQ(judgement.reason, "no memory for the sandbox");
    EXPECT_TRUE(judgement.findings.empty());
}

/// The lens moves a little from run to run, as where all pixels share one pattern of lens points.
class OnePattern final : public probe::Examinee {
public:
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        oracle::Mistake mistake;
        mistake.lensOffsetX = 0.1 * static_cast<double>(runs_ % 3) - 0.1;
        mistake.lensOffsetY = 0.1 * static_cast<double>(runs_ % 2);
        ++runs_;
        return OracleExaminee{{}, mistake, false}.ask(questions);
    }

private:
    int runs_ = 0;
};

TEST(JudgeScreenshot, BlamesNobodyWhosePicturesDifferFromOneToTheNext) {
    OnePattern code;
    const ScreenshotStudent student{scenes(), false, code};
    double unused = 0.0;
    const TaskJudgement judgement = student.handIn(student.render(640, kSeed), kSeed, unused);
    EXPECT_EQ(judgement.state, TaskState::passed) << judgement.findings.at(0).message;
    EXPECT_EQ(firstId(judgement), "screenshot.unverified");
}

TEST(JudgeScreenshot, JudgesTheSceneAloneWhereThereIsNoCode) {
    const auto judgeAlone = [](const Picture& picture) {
        std::vector<tasks::screenshot::Scene> known(1);
        known[0].name = "bump-mapping";
        known[0].expected = [] {
            const raytracer::ByteImage& image = scenes()[0].expected().picture;
            return metrics::ByteView{image.width, image.height, image.rgb};
        };
        return tasks::judgeScreenshot(picture.view(), known, kSeed);
    };
    oracle::Reading reading;
    reading.bump.uOrigin = 0.25;
    OracleExaminee other{reading, {}, true};
    const TaskJudgement right =
        judgeAlone(ScreenshotStudent{scenes(), true, other}.render(640, kSeed));
    EXPECT_EQ(right.state, TaskState::blocked);
    EXPECT_EQ(right.reason, "not checked: there is no code that runs to compare it with");
    EXPECT_TRUE(right.findings.empty());
    EXPECT_EQ(firstId(judgeAlone(photograph(640, 480, kSeed))), "screenshot.not-this-scene");
}

TEST(JudgeScreenshot, WithoutScenesJudgesTheSizeAlone) {
    EXPECT_EQ(tasks::judgeScreenshot(photograph(640, 480, 1).view(), {}, 1).reason,
              "not checked: there is no scene to compare it with");
    EXPECT_EQ(firstId(tasks::judgeScreenshot(photograph(640, 400, 1).view(), {}, 1)),
              "screenshot.wrong-size");
    const Picture large{4400, 3300, std::vector<std::uint8_t>(std::size_t{4400} * 3300 * 3)};
    EXPECT_EQ(firstId(tasks::judgeScreenshot(large.view(), {}, 1)), "screenshot.wrong-size")
        << "no frame of a question is so large";
}

}  // namespace
}  // namespace ticker::selftest
