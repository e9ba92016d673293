// Only code that repeats its renders under equal conditions can disprove a picture.
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/screenshot/Repetition.h>
#include <grader/tasks/screenshot/UnlikeItself.h>
#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tests/tasks/screenshot/GreyExaminee.h>

#include <gtest/gtest.h>

#include <functional>

namespace ticker::tasks::screenshot {
namespace {

using Grey = std::function<double(const GreyPixel&)>;

double ofItsOwnPixel(const GreyPixel& pixel) {
    return 0.3 + 0.1 * noiseOf(pixel.settings.seed, pixel.place(), 0);
}

std::string why(const Grey& grey, bool isDeterministic = false, bool knowsParts = true) {
    GreyExaminee code{{.grey = grey, .knowsParts = knowsParts}};
    const raytracer::SceneDescription description;
    Scene scene;
    scene.isRandom = !isDeterministic;
    scene.description = &description;
    scene.examinee = &code;
    return whyNotRepeated(scene, 640, 480, 3);
}

TEST(Repetition, IsThereWherePixelsFollowFromSeedAndPlace) {
    EXPECT_EQ(why(ofItsOwnPixel), "");
    EXPECT_EQ(why(ofItsOwnPixel, false, false), "") << "whole frames only";
    EXPECT_EQ(
        why([](const GreyPixel& pixel) { return 0.001 * static_cast<double>(pixel.place() % 7); },
            true),
        "");
}

TEST(Repetition, IsMissingWhereThreadsMeet) {
    for (const bool knowsParts : {true, false})
        EXPECT_NE(why(
                      [](const GreyPixel& pixel) {
                          const bool lost = pixel.settings.threads > 1 && pixel.place() % 64 == 0;
                          return ofItsOwnPixel(pixel) - (lost ? 1e-6 : 0.0);
                      },
                      false, knowsParts),
                  "")
            << "far below a step of a byte";
}

TEST(Repetition, IsMissingWhereNumbersAreDrawnAnewInEachProcess) {
    EXPECT_NE(why([](const GreyPixel& pixel) {
                  return 0.3 + 0.1 * noiseOf(pixel.run, pixel.place(), 1);
              }),
              "");
}

TEST(Repetition, IsMissingWhereTheFirstPixelDecidesForAll) {
    EXPECT_NE(why([](const GreyPixel& pixel) {
                  return ofItsOwnPixel(pixel) + (pixel.question == 0 ? 1e-6 : 0.0);
              }),
              "");
}

TEST(Repetition, IsMissingWhereAllPixelsShareWhatASeedDecides) {
    EXPECT_NE(why([](const GreyPixel& pixel) {
                  return ofItsOwnPixel(pixel) + 0.2 * noiseOf(pixel.settings.seed, 0, 2);
              }),
              "");
}

TEST(Repetition, IsNotExpectedOfCodeWhoseFindingsSayThatItDrawsDifferently) {
    const auto whyWith = [](const FindingText& text) {
        TaskReport task;
        task.findings.push_back({});
        task.findings.back().id = text.id;
        return whyUnlikeItself({TaskReport{}, task});
    };
    for (const FindingText* text : {&kShadowThreadsMixed, &kDofThreadsMixed, &kShadowFixedSamples,
                                    &kDofSharedSamples, &kDofReusedPattern})
        EXPECT_NE(whyWith(*text), "") << text->id;
    EXPECT_EQ(whyWith(kShadowHard), "");
    EXPECT_EQ(whyUnlikeItself({}), "");
}

TEST(Repetition, IsNotAskedForWhereItIsKnownOrThereIsNoCode) {
    Scene scene;
    EXPECT_EQ(whyNotRepeated(scene, 640, 480, 3), "");
    GreyExaminee code{{.grey = ofItsOwnPixel}};
    scene.examinee = &code;
    scene.whyUnlikeItself = "its threads meet";
    EXPECT_EQ(whyNotRepeated(scene, 640, 480, 3), "its threads meet");
}

}  // namespace
}  // namespace ticker::tasks::screenshot
