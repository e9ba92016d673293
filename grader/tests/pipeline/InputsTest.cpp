#include <grader/pipeline/Inputs.h>

#include <gtest/gtest.h>

namespace ticker::pipeline {
namespace {

using intake::Part;

intake::Submission submission(const std::string& renderer) {
    intake::Submission result;
    result.name = "ann";
    result.parts[static_cast<std::size_t>(Part::renderer)] = renderer;
    return result;
}

constexpr std::uint64_t kSeed = 7;

TEST(QuestionSeed, IsTheSameForTheSameFilesUnderTheSameSeed) {
    intake::Submission again = submission("x");
    again.name = "bob";
    again.ignored = {"notes.txt"};
    EXPECT_EQ(questionSeed(submission("x"), kSeed), questionSeed(again, kSeed));
}

TEST(QuestionSeed, IsAnotherForEveryOtherFile) {
    intake::Submission moved;
    moved.parts[static_cast<std::size_t>(Part::bumpySphere)] = "x";
    intake::Submission more = submission("x");
    more.parts[static_cast<std::size_t>(Part::screenshot)] = "";
    const std::uint64_t first = questionSeed(submission("x"), kSeed);
    for (const intake::Submission& other : {submission("x "), submission(""), moved, more})
        EXPECT_NE(questionSeed(other, kSeed), first);
}

TEST(QuestionSeed, IsAnotherForEveryClass) {
    EXPECT_NE(questionSeed(submission("x"), kSeed), questionSeed(submission("x"), kSeed + 1));
    EXPECT_NE(questionSeed(submission("x"), kSeed), kSeed);
}

}  // namespace
}  // namespace ticker::pipeline
