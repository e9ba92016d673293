#include <grader/tasks/lens/checks/PictureCheck.h>
#include <grader/tasks/lens/checks/PictureMistakes.h>

#include <gtest/gtest.h>

#include <string>
#include <utility>

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
    const std::vector<PictureMistake> mistakes = pictureMistakes(1.0);
    const Bank bank = tryAll(mistakes, asked(), seeing(expected().mean), expected(), kSeed);
    EXPECT_EQ(bank.best, nullptr);
    EXPECT_EQ(bank.second, nullptr);
    EXPECT_EQ(bank.largest, 0.0);
    EXPECT_EQ(bank.squares, 0.0);
    EXPECT_EQ(bank.spread, 0.0);
    EXPECT_EQ(bank.bestLeaves, 1.0);
}

TEST(TryAll, NamesTheSuspectWhosePictureItIs) {
    const std::vector<PictureMistake> mistakes = pictureMistakes(1.0);
    ASSERT_EQ(mistakes.size(), 11U);
    for (const std::size_t i : {0U, 1U, 4U, 9U}) {
        const PictureMistake& own = mistakes[i];
        const Plane picture = mistakenPicture(asked(), own.reading, own.mistake, kSeed);
        const Bank bank = tryAll(mistakes, asked(), seeing(picture), expected(), kSeed);
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

}  // namespace
}  // namespace ticker::tasks
