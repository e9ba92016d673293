#include <grader/lab/calibrate/CodeOnly.h>

#include <gtest/gtest.h>

namespace ticker::calibrate {
namespace {

TEST(CodeOnly, LeavesOutCommentsAndWhiteSpace) {
    EXPECT_EQ(codeOnly("int a = 1;  // one\n\n/* two\n lines */ int b;"), "int a=1;int b;");
    EXPECT_EQ(codeOnly("return x;"), codeOnly("return\n    x;"));
    EXPECT_NE(codeOnly("return x;"), codeOnly("returnx;"));
}

TEST(CodeOnly, KeepsAFindingsIdAndLeavesOutItsWords) {
    EXPECT_EQ(codeOnly(R"(find("shadow.hard", "It is hard."))"), R"(find("shadow.hard",""))");
    EXPECT_NE(codeOnly(R"(find("shadow.hard"))"), codeOnly(R"(find("shadow.wrong"))"));
}

TEST(CodeOnly, TakesStringsBesideEachOtherForOne) {
    EXPECT_EQ(codeOnly("f(\"The light is\" \" hard\"\n  \"er.\")"),
              codeOnly(R"(f("Another text."))"));
}

TEST(CodeOnly, KnowsWhatOnlyLooksLikeAStringOrAComment) {
    EXPECT_EQ(codeOnly("char c = '\"'; int n = 1'000; // end"), "char c='\"';int n=1'000;");
    EXPECT_EQ(codeOnly(R"(f("a//b"); g('\'');)"), R"(f("a//b");g('\'');)");
    EXPECT_EQ(codeOnly("f(R\"x(a \"b\" )y\" c)x\");"), "f(\"\");");
}

TEST(CodeOnly, EndsADirectiveWithItsLine) {
    EXPECT_NE(codeOnly("#define A\nB"), codeOnly("#define A B"));
    EXPECT_EQ(codeOnly("#define A  // why\nB"), codeOnly("#define A\nB"));
}

}  // namespace
}  // namespace ticker::calibrate
