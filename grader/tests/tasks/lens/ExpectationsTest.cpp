#include <grader/tasks/lens/checks/Expectations.h>
#include <grader/tasks/lens/checks/PictureMistakes.h>
#include <grader/tasks/lens/questions/PictureQuestions.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ticker::tasks {
namespace {

constexpr std::uint64_t kSeed = 5;

/// Few pixels and repetitions.
probe::RenderQuestion smallQuestion() {
    probe::RenderQuestion asked = drawPictureQuestion(kSeed);
    asked.settings.width = 8;
    asked.settings.height = 6;
    asked.repetitions = 2;
    return asked;
}

TEST(Expectations, AreTheOraclesPictures) {
    Expectations expectations{smallQuestion(), kSeed};
    oracle::Reading half;
    half.apertureFactor = 0.5;
    for (const oracle::Reading& reading : {oracle::Reading{}, half})
        for (const Exactness exactness : {Exactness::judging, Exactness::rough})
            EXPECT_EQ(expectations.under(reading, exactness).mean,
                      expectedPicture(smallQuestion(), reading, kSeed, exactness).mean);
    const std::vector<PictureMistake> mistakes = pictureMistakes(half);
    for (std::size_t i = 0; i < mistakes.size(); ++i)
        EXPECT_EQ(expectations.underMistake(half, i, Exactness::rough),
                  templateOf(mistakes[i], smallQuestion(), kSeed + 1, Exactness::rough));
}

TEST(Expectations, AreComputedOnce) {
    Expectations expectations{smallQuestion(), kSeed};
    const ExpectedPicture* first = &expectations.under({}, Exactness::rough);
    const Plane* mistaken = &expectations.underMistake({}, 0, Exactness::rough);
    oracle::Reading antialiased;
    antialiased.pixelSpread = 1.0;
    EXPECT_NE(&expectations.under(antialiased, Exactness::rough), first);
    EXPECT_NE(&expectations.under({}, Exactness::judging), first);
    EXPECT_EQ(&expectations.under({}, Exactness::rough), first);
    EXPECT_NE(&expectations.underMistake({}, 1, Exactness::rough), mistaken);
    EXPECT_EQ(&expectations.underMistake({}, 0, Exactness::rough), mistaken);
}

TEST(ExpectationShelf, KeepsTheQuestionsOfASeedApart) {
    ExpectationShelf shelf;
    const auto several = expectationsOf(shelf, drawPictureQuestion(kSeed), kSeed);
    EXPECT_EQ(expectationsOf(shelf, drawPictureQuestion(kSeed), kSeed), several);
    EXPECT_NE(expectationsOf(shelf, drawPictureQuestion(kSeed, true), kSeed), several);
    EXPECT_NE(expectationsOf(shelf, drawFinePictureQuestion(kSeed), kSeed), several);
    EXPECT_NE(expectationsOf(shelf, drawPictureQuestion(kSeed + 1), kSeed + 1), several);
}

}  // namespace
}  // namespace ticker::tasks
