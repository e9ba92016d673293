#include <grader/session/LineDiff.h>

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace ticker::session {
namespace {

/// The text that a diff says was there before ('-') or is there now ('+').
std::string side(const std::vector<DiffLine>& diff, char kind) {
    std::string text;
    for (const DiffLine& line : diff)
        if (line.kind == ' ' || line.kind == kind) text += std::string{line.text} + "\n";
    return text;
}

TEST(LineDiff, TakesOutAndPutsInAsLittleAsPossible) {
    EXPECT_EQ(lineDiff("a\nb\nc\n", "a\nx\nc\n"),
              (std::vector<DiffLine>{{' ', "a"}, {'-', "b"}, {'+', "x"}, {' ', "c"}}));
    EXPECT_EQ(lineDiff("a\nb\n", "a\nb\n"), (std::vector<DiffLine>{{' ', "a"}, {' ', "b"}}));
    EXPECT_EQ(lineDiff("", "a\n"), (std::vector<DiffLine>{{'+', "a"}}));
    EXPECT_EQ(lineDiff("a\n", ""), (std::vector<DiffLine>{{'-', "a"}}));
    EXPECT_EQ(lineDiff("a\nb\na\n", "b\n"),
              (std::vector<DiffLine>{{'-', "a"}, {' ', "b"}, {'-', "a"}}));
}

TEST(LineDiff, KeepsBothTextsWhole) {
    std::mt19937 random{11};
    const auto text = [&] {
        std::string lines;
        for (std::size_t i = random() % 30; i > 0; --i)
            lines += std::string(1, static_cast<char>('a' + random() % 4)) + "\n";
        return lines;
    };
    for (int i = 0; i < 300; ++i) {
        const std::string before = text();
        const std::string after = text();
        const auto diff = lineDiff(before, after);
        EXPECT_EQ(side(diff, '-'), before);
        EXPECT_EQ(side(diff, '+'), after);
    }
}

TEST(LineDiff, ReplacesVeryLongTextsAsAWhole) {
    std::string before;
    for (int i = 0; i < 2500; ++i)
        before += "x" + std::to_string(i) + "\n";
    const std::string after = "y\n" + before + "y\n";
    const auto diff = lineDiff(before, after);
    EXPECT_EQ(side(diff, '-'), before);
    EXPECT_EQ(side(diff, '+'), after);
}

}  // namespace
}  // namespace ticker::session
