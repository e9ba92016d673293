#include <grader/base/ShellQuoted.h>
#include <grader/tests/support/RunCommand.h>

#include <gtest/gtest.h>

#include <string>

namespace ticker {
namespace {

TEST(ShellQuoted, LeavesAPlainWordAsItIs) {
    EXPECT_EQ(shellQuoted("out/my-class_2.zip"), "out/my-class_2.zip");
}

TEST(ShellQuoted, GivesAShellTheSameText) {
    for (const std::string text :
         {"", "two words", "Ann's", "$HOME `x` \\ \"y\" !", "a;b", "~", "*", "''"}) {
        EXPECT_EQ(tests::runCommand("printf %s " + shellQuoted(text)).output, text);
        EXPECT_EQ(tests::runCommand("printf %s '" + insideSingleQuotes(text) + "'").output, text);
    }
}

}  // namespace
}  // namespace ticker
