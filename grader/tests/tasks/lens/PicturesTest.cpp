#include <grader/tasks/lens/checks/PictureCheck.h>
#include <grader/tasks/lens/questions/PictureQuestions.h>
#include <grader/tests/tasks/lens/OraclePictures.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace ticker::tasks {
namespace {

// With these seeds some pixels show an object to one lens ray in thousands. An oracle that misses
// the object expects no noise there. The largest statistic of a stage exceeds 0.8 of its
// limit with a chance of about 1e-4.
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

// Missed with a chance below 1e-6.
TEST(Pictures, JudgeMirroredRaysThatLeaveTowardsTheEye) {
    const probe::RenderQuestion asked = drawPictureQuestion(5);
    probe::RenderQuestion halfBlind = asked;
    std::erase_if(halfBlind.scene.spheres,
                  [](const auto& sphere) { return sphere.centre.z < 0.0; });
    ASSERT_NE(halfBlind.scene.spheres.size(), asked.scene.spheres.size());
    EXPECT_TRUE(judgePictures(asked, answerOf(halfBlind, 8), 5).finding);
}

// All pixels of a picture share fifty lens points: each picture is the mean of fifty sharp ones.
probe::RenderAnswer sharedAnswerOf(const probe::RenderQuestion& asked, std::uint64_t seed) {
    oracle::Mistake shared;
    shared.lensSharedByFrame = true;
    probe::RenderQuestion oneRay = asked;
    oneRay.settings.dofRayCount = 1;
    probe::RenderAnswer answer;
    const int rays = asked.settings.dofRayCount;
    for (int ray = 0; ray < rays; ++ray) {
        const probe::RenderAnswer one =
            answerOf(oneRay, seed + static_cast<std::uint64_t>(ray), shared);
        if (ray == 0) {
            answer = one;
            for (auto& image : answer.images)
                std::fill(image.begin(), image.end(), raytracer::ColourRGB{});
        }
        for (std::size_t i = 0; i < one.images.size(); ++i)
            for (std::size_t pixel = 0; pixel < one.images[i].size(); ++pixel)
                answer.images[i][pixel] += one.images[i][pixel] * (1.0 / rays);
    }
    return answer;
}

// With visible rays such points are a warning. Otherwise the noise of all pixels is correlated: the
// submission may pass or need review, but must not fail.
TEST(Pictures, DoNotFailWhereThePixelsNoiseGoesTogether) {
    int forAPerson = 0;
    for (const bool onePicture : {false, true})
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            const probe::RenderQuestion asked = drawPictureQuestion(seed, onePicture);
            const PictureVerdict verdict =
                judgePictures(asked, sharedAnswerOf(asked, 1000 * seed), seed);
            EXPECT_FALSE(verdict.finding) << seed << ": " << verdict.finding->id;
            if (verdict.ambiguous) ++forAPerson;
        }
    EXPECT_GT(forAPerson, 0);
}

// A grid of eight by eight lens points from edge to edge blurs as much as random points on a lens
// that is wider by sqrt(9/7). The noise of repetitions tells a wider lens from a grid. Missed, and
// wrongly failed, with a chance below 1e-6.
TEST(Pictures, AcceptTheBlurOfAGridFromEdgeToEdgeWhereTheyRepeatThemselves) {
    oracle::Reading wider;
    wider.apertureFactor = std::sqrt(9.0 / 7.0);
    for (const double spread : {0.0, 1.0}) {
        wider.pixelSpread = spread;
        const probe::RenderQuestion one = drawPictureQuestion(6, true);
        const PictureVerdict repeated = judgePictures(one, answerOf(one, 7, {}, wider), 6);
        EXPECT_FALSE(repeated.finding) << spread;
        EXPECT_FALSE(repeated.ambiguous) << spread;
        const probe::RenderQuestion eight = drawPictureQuestion(6);
        const PictureVerdict random = judgePictures(eight, answerOf(eight, 7, {}, wider), 6);
        ASSERT_TRUE(random.finding) << spread;
        EXPECT_EQ(random.finding->id, "dof.aperture-size") << spread;
    }
}

// A picture that is unrelated to the scene is not noise, even if its pixels are correlated.
TEST(Pictures, FailWhereNothingIsDrawn) {
    for (const bool onePicture : {false, true}) {
        const probe::RenderQuestion asked = drawPictureQuestion(3, onePicture);
        probe::RenderAnswer answer = answerOf(asked, 3);
        for (const double grey : {0.0, 0.2}) {
            for (auto& image : answer.images)
                std::fill(image.begin(), image.end(), raytracer::ColourRGB{grey});
            const PictureVerdict verdict = judgePictures(asked, answer, 3);
            ASSERT_TRUE(verdict.finding) << grey;
            EXPECT_TRUE(verdict.finding->id == "dof.wrong" ||
                        verdict.finding->id == "dof.not-averaged")
                << verdict.finding->id;
        }
    }
}

}  // namespace
}  // namespace ticker::tasks
