#include <grader/pipeline/Inputs.h>

#include <gtest/gtest.h>

namespace ticker::pipeline {
namespace {

using intake::Part;

intake::Submission submissionOf(const std::string& renderer) {
    intake::Submission result;
    result.name = "ann";
    result.parts[static_cast<std::size_t>(Part::renderer)] = renderer;
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
    moved.parts[static_cast<std::size_t>(Part::bumpySphere)] = "x";
    intake::Submission more = submissionOf("x");
    more.parts[static_cast<std::size_t>(Part::screenshot)] = "";
    const std::uint64_t first = questionSeed(submissionOf("x"), kClassSeed);
    for (const intake::Submission& other : {submissionOf("x "), submissionOf(""), moved, more})
        EXPECT_NE(questionSeed(other, kClassSeed), first);
}

TEST(QuestionSeed, IsAnotherForEveryClass) {
    EXPECT_NE(questionSeed(submissionOf("x"), kClassSeed), questionSeed(submissionOf("x"), kClassSeed + 1));
    EXPECT_NE(questionSeed(submissionOf("x"), kClassSeed), kClassSeed);
}

}  // namespace
}  // namespace ticker::pipeline
