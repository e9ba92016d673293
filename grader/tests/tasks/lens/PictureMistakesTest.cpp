#include <grader/tasks/lens/checks/PictureCheck.h>
#include <grader/tasks/lens/checks/PictureMistakes.h>
#include <grader/tasks/lens/questions/PictureQuestions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace ticker::tasks {
namespace {

constexpr std::uint64_t kSeed = 5;

const probe::RenderQuestion& asked() {
    static const probe::RenderQuestion drawn = drawPictureQuestion(kSeed);
    return drawn;
}

const ExpectedPicture& expected() {
    static const ExpectedPicture picture = expectedPicture(asked(), {}, kSeed);
    return picture;
}

std::vector<Plane> templatesOf(const std::vector<PictureMistake>& mistakes) {
    return mistakenPictures(mistakes, asked(), kSeed);
}

/// One picture without any noise.
SeenPictures seeing(Plane pixels) {
    SeenPictures seen;
    seen.width = asked().settings.width;
    seen.identical = true;
    seen.variance = Plane(pixels.size(), 0.0);
    seen.renders = {pixels};
    seen.mean = std::move(pixels);
    return seen;
}

TEST(TryAll, FindsNothingInThePictureThatIsExpected) {
    const std::vector<PictureMistake> mistakes = pictureMistakes({});
    const Bank bank = tryAll(mistakes, templatesOf(mistakes), seeing(expected().mean), expected());
    EXPECT_EQ(bank.best, nullptr);
    EXPECT_EQ(bank.second, nullptr);
    EXPECT_EQ(bank.largest, 0.0);
    EXPECT_EQ(bank.squares, 0.0);
    EXPECT_EQ(bank.spread, 0.0);
    EXPECT_EQ(bank.bestLeaves, 1.0);
}

TEST(TryAll, NamesTheSuspectWhosePictureItIs) {
    const std::vector<PictureMistake> mistakes = pictureMistakes({});
    ASSERT_EQ(mistakes.size(), 11U);
    for (const std::size_t i : {0U, 1U, 4U, 9U}) {
        const PictureMistake& own = mistakes[i];
        const Plane picture = mistakenPicture(asked(), own.reading, own.mistake, kSeed);
        const Bank bank = tryAll(mistakes, templatesOf(mistakes), seeing(picture), expected());
        ASSERT_NE(bank.best, nullptr);
        EXPECT_EQ(bank.best, &own) << own.text->id;
        EXPECT_NEAR(bank.bestMatch.amplitude, 1.0, 1e-9);
        EXPECT_NEAR(bank.bestLeaves, 0.0, 1e-9);
        EXPECT_NEAR(bank.largest, bank.bestMatch.z, 1e-9);
        EXPECT_GT(bank.squares, bank.largest * bank.largest);
        ASSERT_NE(bank.second, nullptr);
        EXPECT_NE(bank.second->text, own.text);
    }
}

TEST(TryAll, NeglectsATwentiethOfAMistake) {
    const std::vector<PictureMistake> mistakes{pictureMistakes({}).at(4)};
    const Plane mistaken =
        mistakenPicture(asked(), mistakes[0].reading, mistakes[0].mistake, kSeed);
    const auto bankOf = [&](double share) {
        Plane picture = expected().mean;
        for (std::size_t i = 0; i < picture.size(); ++i)
            picture[i] += share * (mistaken[i] - picture[i]);
        return tryAll(mistakes, templatesOf(mistakes), seeing(picture), expected());
    };
    EXPECT_EQ(bankOf(0.049).beyond, 0.0);
    EXPECT_GT(bankOf(0.049).largest, 0.0);
    for (const double share : {0.1, 1.0, -0.1}) {
        const Bank bank = bankOf(share);
        EXPECT_NEAR(bank.beyond, bank.largest * (1.0 - 0.05 / std::abs(share)), 1e-9);
    }
}

// The change that a factor of the brightness makes has the same shape for all factors.
TEST(TryAll, PrefersTheAmplitudeNearestToOneAmongShapesThatAreAlike) {
    const auto scaledBy = [](double factor) {
        PictureMistake mistake = pictureMistakes({}).at(9);
        mistake.mistake.pixelScale = factor;
        return mistake;
    };
    for (const double seen : {1.1, 1.2})
        for (const bool ownFirst : {false, true}) {
            const double other = seen == 1.1 ? 1.2 : 1.1;
            const std::vector<PictureMistake> mistakes{scaledBy(ownFirst ? seen : other),
                                                       scaledBy(ownFirst ? other : seen)};
            const PictureMistake& own = mistakes[ownFirst ? 0 : 1];
            const Plane picture = mistakenPicture(asked(), own.reading, own.mistake, kSeed);
            EXPECT_EQ(tryAll(mistakes, templatesOf(mistakes), seeing(picture), expected()).best,
                      &own)
                << seen << ownFirst;
        }
}

TEST(PictureMistakes, ChangeOneThingByAsMuchAsStudentsDo) {
    for (const double factor : {1.0, 0.5}) {
        oracle::Reading accepted;
        accepted.apertureFactor = factor;
        accepted.pixelSpread = 0.7;
        const std::vector<PictureMistake> all = pictureMistakes(accepted);
        const auto changed = [&](std::size_t i) { return all.at(i).mistake; };
        EXPECT_TRUE(changed(1).focalByDistance);
        EXPECT_EQ(changed(2).focalFactor, 0.85);
        EXPECT_EQ(changed(3).focalFactor, 1.2);
        for (const std::size_t i : {4U, 5U}) {
            EXPECT_EQ(changed(i).lensOffsetX, 1.0);
            EXPECT_EQ(changed(i).lensOffsetY, 1.0);
        }
        EXPECT_EQ(all[5].reading.apertureFactor, 0.5 * factor);
        EXPECT_EQ(all[7].reading.apertureFactor, 0.7 * factor);
        EXPECT_EQ(all[8].reading.apertureFactor, 1.4 * factor);
        EXPECT_EQ(changed(9).pixelScale, 1.1);
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_EQ(all[i].withoutBounces, i == 10);
            EXPECT_EQ(all[i].reading.pixelSpread, 0.7);
        }
    }
}

// The error of the mean adds a 25th to the variance of the mean of all renders.
TEST(ExpectedPicture, IsSurerThanWhatItIsComparedWith) {
    double error = 0.0;
    double variance = 0.0;
    for (std::size_t i = 0; i < expected().mean.size(); ++i) {
        error += expected().error[i];
        variance += expected().variance[i] / asked().repetitions;
    }
    EXPECT_LT(error, 0.06 * variance);
    EXPECT_GT(error, 0.0);
}

}  // namespace
}  // namespace ticker::tasks
