// Only code that repeats its renders under equal conditions can disprove a picture.
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/screenshot/Repetition.h>
#include <grader/tasks/screenshot/UnlikeItself.h>
#include <grader/tasks/shadows/ShadowFindings.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <utility>

namespace ticker::tasks::screenshot {
namespace {

/// A pseudo-random number between 0 and 1 from three numbers.
double noise(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
    std::uint64_t mixed = a * 0x9E3779B97F4A7C15U + b * 0xD1342543DE82EF95U + c + 1;
    for (int i = 0; i < 3; ++i)
        mixed = (mixed ^ (mixed >> 31U)) * 0xBF58476D1CE4E5B9U;
    return static_cast<double>(mixed >> 11U) * 0x1p-53;
}

/// Everything on which a pixel of a render may depend.
struct Pixel {
    std::uint64_t run;
    std::uint64_t question;  ///< within the run
    std::uint64_t seed;
    std::uint64_t place;  ///< in the full frame
    int threads;
};
using Grey = std::function<double(const Pixel&)>;

double ofItsOwnPixel(const Pixel& pixel) {
    return 0.3 + 0.1 * noise(pixel.seed, pixel.place, 0);
}

class Code final : public probe::Examinee {
public:
    Code(Grey grey, bool knowsParts) : grey_(std::move(grey)), knowsParts_(knowsParts) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        probe::Run run;
        for (std::size_t i = 0; i < questions.size(); ++i)
            run.answers.emplace_back(
                render(std::get<probe::RenderQuestion>(questions[i]).settings, i));
        ++runs_;
        return run;
    }

private:
    probe::RenderAnswer render(const raytracer::RenderSettings& settings, std::size_t question) {
        probe::RenderAnswer answer;
        answer.state = probe::AnswerState::answered;
        answer.width = settings.imageWidth();
        answer.height = settings.imageHeight();
        answer.wrongSize = !knowsParts_ && !settings.region.isWholeFrame();
        answer.images.resize(1);
        for (int y = 0; y < answer.height; ++y)
            for (int x = 0; x < answer.width; ++x) {
                const int place = (settings.region.y + y) * settings.width + settings.region.x + x;
                answer.images[0].emplace_back(
                    grey_({runs_, question, settings.seed, static_cast<std::uint64_t>(place),
                           settings.threads}));
            }
        return answer;
    }

    Grey grey_;
    bool knowsParts_;
    std::uint64_t runs_ = 0;
};

std::string why(const Grey& grey, bool isDeterministic = false, bool knowsParts = true) {
    Code code{grey, knowsParts};
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
        why([](const Pixel& pixel) { return 0.001 * static_cast<double>(pixel.place % 7); }, true),
        "");
}

TEST(Repetition, IsMissingWhereThreadsMeet) {
    for (const bool knowsParts : {true, false})
        EXPECT_NE(why(
                      [](const Pixel& pixel) {
                          const bool lost = pixel.threads > 1 && pixel.place % 64 == 0;
                          return ofItsOwnPixel(pixel) - (lost ? 1e-6 : 0.0);
                      },
                      false, knowsParts),
                  "")
            << "far below a step of a byte";
}

TEST(Repetition, IsMissingWhereNumbersAreDrawnAnewInEachProcess) {
    EXPECT_NE(why([](const Pixel& pixel) { return 0.3 + 0.1 * noise(pixel.run, pixel.place, 1); }),
              "");
}

TEST(Repetition, IsMissingWhereTheFirstPixelDecidesForAll) {
    EXPECT_NE(why([](const Pixel& pixel) {
                  return ofItsOwnPixel(pixel) + (pixel.question == 0 ? 1e-6 : 0.0);
              }),
              "");
}

TEST(Repetition, IsMissingWhereAllPixelsShareWhatASeedDecides) {
    EXPECT_NE(why([](const Pixel& pixel) {
                  return ofItsOwnPixel(pixel) + 0.2 * noise(pixel.seed, 0, 2);
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
    Code code{ofItsOwnPixel, true};
    scene.examinee = &code;
    scene.whyUnlikeItself = "its threads meet";
    EXPECT_EQ(whyNotRepeated(scene, 640, 480, 3), "its threads meet");
}

}  // namespace
}  // namespace ticker::tasks::screenshot
