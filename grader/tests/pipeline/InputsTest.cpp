#include <grader/pipeline/InputDigests.h>
#include <grader/tests/pipeline/TestGrader.h>

#include <gtest/gtest.h>

namespace ticker::pipeline {
namespace {

intake::Submission submissionOf(const std::string& renderer) {
    intake::Submission result;
    result.name = "ann";
    result.parts["Renderer.cpp"] = renderer;
    return result;
}

constexpr std::uint64_t kClassSeed = 7;

TEST(QuestionSeed, IsTheSameForTheSameFilesUnderTheSameSeed) {
    intake::Submission again = submissionOf("x");
    again.name = "bob";
    again.ignored = {"notes.txt"};
    EXPECT_EQ(questionSeed(submissionOf("x"), kClassSeed), questionSeed(again, kClassSeed));
}

TEST(QuestionSeed, IsAnotherForEveryOtherFile) {
    intake::Submission moved;
    moved.parts["BumpySphere.cpp"] = "x";
    intake::Submission more = submissionOf("x");
    more.parts["screenshot.png"] = "";
    const std::uint64_t first = questionSeed(submissionOf("x"), kClassSeed);
    for (const intake::Submission& other : {submissionOf("x "), submissionOf(""), moved, more})
        EXPECT_NE(questionSeed(other, kClassSeed), first);
}

TEST(QuestionSeed, IsAnotherForEveryClass) {
    EXPECT_NE(questionSeed(submissionOf("x"), kClassSeed),
              questionSeed(submissionOf("x"), kClassSeed + 1));
    EXPECT_NE(questionSeed(submissionOf("x"), kClassSeed), kClassSeed);
}

TEST(HowDigest, IsThatOfTheResultsOfALevelAndAnotherForEveryOtherWay) {
    Grader grader = tests::testGrader();
    const std::string level = sandbox::toString(grader.sandbox.level());
    const std::string how = inputsOf(submissionOf("x"), grader, kClassSeed).how;
    EXPECT_EQ(howDigest(grader, level, kClassSeed), how);
    EXPECT_NE(howDigest(grader, "of another machine", kClassSeed), how);
    EXPECT_NE(howDigest(grader, level, kClassSeed + 1), how);
    grader.rubricText = "{}";
    EXPECT_NE(howDigest(grader, level, kClassSeed), how);
    grader = tests::testGrader();
    grader.option = "T1";
    EXPECT_NE(howDigest(grader, level, kClassSeed), how);
}

}  // namespace
}  // namespace ticker::pipeline
