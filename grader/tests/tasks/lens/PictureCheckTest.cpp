// Bounds of the judgement of pictures: each picture is the expected one plus a known change.
#include <grader/tasks/lens/answers/Pictures.h>
#include <grader/tasks/lens/checks/PictureCheck.h>
#include <grader/tasks/lens/questions/PictureQuestions.h>
#include <grader/tests/tasks/lens/OraclePictures.h>
#include <grader/tests/tasks/support/InFinding.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>

namespace ticker::tasks {
namespace {

constexpr std::uint64_t kPictureSeed = 5;

/// What is added to a pixel's grey, by its number, repetition and standard deviation.
using Change = std::function<double(std::size_t pixel, int repetition, double deviation)>;

probe::RenderQuestion smallQuestion(bool onePicture) {
    probe::RenderQuestion asked = drawPictureQuestion(kPictureSeed, onePicture);
    asked.settings.width = 8;  // few pixels are quick
    asked.settings.height = 6;
    return asked;
}

PictureVerdict judgeChanged(bool onePicture, const Change& change) {
    const probe::RenderQuestion asked = smallQuestion(onePicture);
    const ExpectedPicture expected = expectedPicture(asked, {}, kPictureSeed);
    probe::RenderAnswer answer;
    answer.state = probe::AnswerState::answered;
    answer.width = asked.settings.width;
    answer.height = asked.settings.height;
    for (int i = 0; i < asked.repetitions; ++i) {
        auto& image = answer.images.emplace_back();
        for (std::size_t pixel = 0; pixel < expected.mean.size(); ++pixel)
            image.emplace_back(expected.mean[pixel] +
                               change(pixel, i, std::sqrt(expected.variance[pixel])));
    }
    return judgePictures(asked, answer, kPictureSeed);
}

PictureVerdict judgeScaled(double factor) {
    const probe::RenderQuestion asked = smallQuestion(false);
    const ExpectedPicture expected = expectedPicture(asked, {}, kPictureSeed);
    probe::RenderAnswer answer;
    answer.state = probe::AnswerState::answered;
    answer.width = asked.settings.width;
    answer.height = asked.settings.height;
    auto& image = answer.images.emplace_back();
    for (const double grey : expected.mean)
        image.emplace_back(grey * factor);
    answer.images.resize(static_cast<std::size_t>(asked.repetitions), image);
    return judgePictures(asked, answer, kPictureSeed);
}

double checkered(std::size_t pixel, int, double deviation) {
    return (pixel / 8 + pixel) % 2 == 0 ? deviation : -deviation;
}

TEST(JudgePictures, AcceptsTheExpectedPicture) {
    const PictureVerdict verdict = judgeChanged(true, [](auto...) { return 0.0; });
    EXPECT_FALSE(verdict.finding);
    EXPECT_FALSE(verdict.ambiguous);
    EXPECT_EQ(verdict.reading.apertureFactor, 1.0);
}

TEST(JudgePictures, NamesABrightnessThatExplainsNearlyAll) {
    for (const double factor : {0.5, 2.0}) {
        const PictureVerdict verdict = judgeScaled(factor);
        ASSERT_EQ(idOf(verdict.finding), "dof.not-averaged") << factor;
    }
}

// The reading that fits least badly is named. The noise of shared lens points never has a width of
// 14 deviations.
TEST(JudgePictures, FailsWhatIsFarFromEveryReading) {
    const PictureVerdict verdict =
        judgeChanged(true, [](std::size_t pixel, int repetition, double deviation) {
            return 14.0 * checkered(pixel, repetition, deviation) * (pixel % 3 == 0 ? 1.0 : 0.4);
        });
    EXPECT_TRUE(verdict.finding);
    EXPECT_FALSE(verdict.ambiguous);
    EXPECT_EQ(verdict.reading.apertureFactor, 1.0);
}

// The means are right. From one picture to the next each pixel changes by the same number of
// standard deviations, every other pixel in the opposite direction.
TEST(JudgePictures, TellsPicturesThatChangeAsAWholeFromNoisyOnes) {
    const auto shared = [](double times) {
        return judgeChanged(false, [=](std::size_t pixel, int repetition, double deviation) {
            return (repetition % 2 == 0 ? times : -times) * deviation *
                   (pixel % 2 == 0 ? 1.0 : -1.0);
        });
    };
    EXPECT_EQ(idOf(shared(0.9).finding), "");
    const PictureVerdict noisy = shared(2.0);
    EXPECT_EQ(idOf(noisy.finding), "dof.too-few-rays") << noisy.excessVariance;
    const PictureVerdict whole = shared(6.0);
    EXPECT_EQ(idOf(whole.finding), "dof.shared-samples");
    EXPECT_GT(whole.excessVariance, 120.0);
    EXPECT_GT(noisy.excessVariance, 9.0);
    EXPECT_LT(whole.excessVariance, 1200.0);
}

}  // namespace
}  // namespace ticker::tasks
