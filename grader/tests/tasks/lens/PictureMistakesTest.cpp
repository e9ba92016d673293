#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/checks/PictureCheck.h>
#include <grader/tasks/lens/checks/PictureMistakes.h>
#include <grader/tasks/lens/questions/PictureQuestions.h>

#include <gtest/gtest.h>

#include <algorithm>
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

Templates templatesOf(const std::vector<PictureMistake>& mistakes) {
    std::vector<Plane> planes;
    for (const PictureMistake& mistake : mistakes)
        planes.push_back(templateOf(mistake, asked(), kSeed));
    return [kept = std::move(planes)](std::size_t index) -> const Plane& { return kept.at(index); };
}

/// The mistakes of this finding, in their order.
std::vector<PictureMistake> mistakesOf(const FindingText& text, const oracle::Reading& accepted) {
    std::vector<PictureMistake> mistakes = pictureMistakes(accepted);
    std::erase_if(mistakes, [&](const PictureMistake& mistake) { return mistake.text != &text; });
    return mistakes;
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
    for (const FindingText* text :
         {&kDofNone, &kDofFocalDistance, &kDofOffCentre, &kDofNotAveraged}) {
        const PictureMistake& own = *std::ranges::find(mistakes, text, &PictureMistake::text);
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
    const std::vector<PictureMistake> mistakes{mistakesOf(kDofOffCentre, {}).at(0)};
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
        PictureMistake mistake = mistakesOf(kDofNotAveraged, {}).at(0);
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
        EXPECT_TRUE(mistakesOf(kDofFocalDistance, accepted).at(0).mistake.focalByDistance);
        const std::vector<PictureMistake> planes = mistakesOf(kDofFocalPlane, accepted);
        EXPECT_EQ(planes.at(0).mistake.focalFactor, 0.85);
        EXPECT_EQ(planes.at(1).mistake.focalFactor, 1.2);
        const std::vector<PictureMistake> offCentre = mistakesOf(kDofOffCentre, accepted);
        for (const PictureMistake& off : offCentre) {
            EXPECT_EQ(off.mistake.lensOffsetX, 1.0);
            EXPECT_EQ(off.mistake.lensOffsetY, 1.0);
        }
        EXPECT_EQ(offCentre.at(1).reading.apertureFactor, 0.5 * factor);
        const std::vector<PictureMistake> apertures = mistakesOf(kDofApertureSize, accepted);
        EXPECT_EQ(apertures.at(0).reading.apertureFactor, 0.7 * factor);
        EXPECT_EQ(apertures.at(1).reading.apertureFactor, 1.4 * factor);
        EXPECT_EQ(mistakesOf(kDofNotAveraged, accepted).at(0).mistake.pixelScale, 1.1);
        for (const PictureMistake& any : pictureMistakes(accepted)) {
            EXPECT_EQ(any.withoutBounces, any.text == &kDofWrong);
            EXPECT_EQ(any.reading.pixelSpread, 0.7);
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
