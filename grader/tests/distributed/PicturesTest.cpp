#include <grader/decision/distributed/PictureCheck.h>
#include <grader/oracle/Oracle.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>

namespace ticker::decision {
namespace {

probe::RenderAnswer answerOf(const probe::RenderQuestion& asked, std::uint64_t seed,
                             const oracle::Mistake& mistake = {}) {
    const oracle::Oracle student{asked.scene, asked.settings, {}, mistake};
    probe::RenderAnswer answer;
    answer.state = probe::AnswerState::answered;
    answer.width = asked.settings.width;
    answer.height = asked.settings.height;
    for (int i = 0; i < asked.repetitions; ++i) {
        const raytracer::Image image =
            student.studentRender(seed * 100 + static_cast<std::uint64_t>(i));
        std::vector<raytracer::ColourRGB> pixels;
        for (int y = 0; y < answer.height; ++y)
            for (int x = 0; x < answer.width; ++x)
                pixels.push_back(image.at(x, y));
        answer.images.push_back(std::move(pixels));
    }
    return answer;
}

// With these seeds some pixels show a thing to one lens ray in thousands: the oracle had not met
// it, and took the pixel for one without noise. The largest statistic of a stage is beyond 0.8 of
// its limit with a chance of about 1e-4.
TEST(Pictures, GiveAPixelThatSeldomSeesSomethingItsNoise) {
    for (const std::uint64_t seed : {4U, 21U, 52U}) {
        const probe::RenderQuestion asked = drawPictureQuestion(seed);
        const PictureVerdict verdict = judgePictures(asked, answerOf(asked, seed + 1), seed);
        EXPECT_LT(verdict.timesTheLimit, 0.8) << seed;
        EXPECT_FALSE(verdict.ambiguous);
    }
}

// One large picture decides as well as eight small ones (missed with a chance below 1e-6).
TEST(Pictures, JudgeCodeThatRepeatsItselfByOneLargePicture) {
    const probe::RenderQuestion asked = drawPictureQuestion(7, true);
    ASSERT_EQ(asked.repetitions, 1);
    EXPECT_FALSE(judgePictures(asked, answerOf(asked, 3), 7).finding);
    oracle::Mistake disc;
    disc.aperture = oracle::Mistake::Aperture::disc;
    const PictureVerdict verdict = judgePictures(asked, answerOf(asked, 3, disc), 7);
    ASSERT_TRUE(verdict.finding);
    EXPECT_EQ(verdict.finding->id, "dof.disc");
}

// One set of lens points for all pixels of a picture is a warning where rays can be seen. Where
// they cannot, its noise goes together: that is for a person, no failure.
TEST(Pictures, AreForAPersonWhereThePixelsNoiseGoesTogether) {
    const probe::RenderQuestion asked = drawPictureQuestion(9);
    probe::RenderAnswer answer = answerOf(asked, 5);
    for (std::size_t i = 0; i < answer.images.size(); ++i)
        for (raytracer::ColourRGB& colour : answer.images[i])
            colour = colour * (i % 2 == 0 ? 1.05 : 1.02);
    const PictureVerdict verdict = judgePictures(asked, answer, 9);
    EXPECT_FALSE(verdict.finding);
    EXPECT_TRUE(verdict.ambiguous);
}

}  // namespace
}  // namespace ticker::decision
