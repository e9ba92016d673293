#include <grader/base/Utf8.h>

#include <gtest/gtest.h>

namespace ticker {
namespace {

TEST(AsUtf8, KeepsValidTextAndReplacesEveryOtherByte) {
    const std::string replaced = "\xEF\xBF\xBD";
    EXPECT_EQ(asUtf8("caf\xC3\xA9 \xE2\x80\x98x\xE2\x80\x99"),
              "caf\xC3\xA9 \xE2\x80\x98x\xE2\x80\x99");
    EXPECT_EQ(asUtf8("caf\xE9!"), "caf" + replaced + "!");
    EXPECT_EQ(asUtf8("\xC0\xAF"), replaced + replaced);                 // overlong
    EXPECT_EQ(asUtf8("\xED\xA0\x80"), replaced + replaced + replaced);  // surrogate
    EXPECT_EQ(asUtf8("\xF0\x9F\x98"), replaced + replaced + replaced);  // cut
    EXPECT_EQ(asUtf8(std::string{"a\0b", 3}), "a" + replaced + "b");
}

TEST(AsPlainLine, KeepsLettersAndReplacesWhatMovesTheCursor) {
    const std::string replaced = "\xEF\xBF\xBD";
    EXPECT_EQ(asPlainLine("caf\xC3\xA9 \xE2\x80\x98x\xE2\x80\x99"),
              "caf\xC3\xA9 \xE2\x80\x98x\xE2\x80\x99");
    EXPECT_EQ(asPlainLine("a\n::error::b"), "a" + replaced + "::error::b");
    EXPECT_EQ(asPlainLine("\x1b[2J\t\x7f"), replaced + "[2J" + replaced + replaced);
    EXPECT_EQ(asPlainLine("\xC2\x9B"
                          "2J"),
              replaced + "2J");  // CSI as one character
    EXPECT_EQ(asPlainLine("a\xE2\x80\xA8"
                          "b"),
              "a" + replaced + "b");                 // a line separator
    EXPECT_EQ(asPlainLine("\xC2\xA0"), "\xC2\xA0");  // a space, no control character
}

TEST(LowerCase, ChangesTheLettersOfAsciiAlone) {
    EXPECT_EQ(lowerCase("Ann_[2].RAR \xC3\x84"), "ann_[2].rar \xC3\x84");
}

}  // namespace
}  // namespace ticker
