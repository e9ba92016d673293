#include <grader/similar/Matcher.h>
#include <grader/similar/PlainLines.h>
#include <grader/similar/SimilarPage.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <fmt/core.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <string>

namespace ticker::similar {
namespace {

/// A function that is long enough to be compared. Texts of different `kind` share no long run.
std::string solution(int kind, const std::string& name) {
    std::string text = "double solve() {\n";
    for (int i = 0; i < 20; ++i)
        text +=
            kind == 0
                ? fmt::format("    const double {0}{1} = f({1}) * ({0} + {1}) - g[{1}];\n", name, i)
                : fmt::format("    if ({0}[{1}] > {0}.at({1})) {{ ++{0}[{1}]; return {1}; }}\n",
                              name, i);
    return text + "}\n";
}

class SimilarFiles : public ::testing::Test {
protected:
    void SetUp() override {
        if (findMatcher().empty()) GTEST_SKIP() << "similarity-tester is not installed";
    }
    sandbox::Sandbox sandbox_ = sandbox::Sandbox::best();
};

TEST_F(SimilarFiles, ACopyWithOtherNamesIsAPairAndAnotherSolutionIsNone) {
    const std::vector<StudentFile> files{{"ann", solution(0, "slope")},
                                         {"bob", "\n\n" + solution(0, "x")},
                                         {"eve", solution(1, "y")}};
    const Comparison comparison = compareFiles(files, {"int stub;\n"}, sandbox_);
    EXPECT_EQ(comparison.compared, 3U);
    ASSERT_EQ(comparison.pairs.size(), 1U);
    const SimilarPair& pair = comparison.pairs.front();
    EXPECT_EQ(pair.left, 0U);
    EXPECT_EQ(pair.right, 1U);
    EXPECT_EQ(pair.percent, 100);
    ASSERT_FALSE(pair.passages.empty());
    EXPECT_EQ(pair.passages.front().left.first, 1);
    EXPECT_EQ(pair.passages.front().right.first, 3) << "two lines further down";
}

TEST_F(SimilarFiles, WhatTheTemplateOrTheReferenceHasDoesNotCount) {
    const std::vector<StudentFile> files{{"ann", solution(0, "slope")}, {"bob", solution(0, "x")}};
    const Comparison comparison = compareFiles(files, {solution(0, "reference")}, sandbox_);
    EXPECT_EQ(comparison.compared, 0U);
    EXPECT_TRUE(comparison.pairs.empty());
    EXPECT_FALSE(comparison.common.at(0).empty());
}

TEST_F(SimilarFiles, AnyBytesAreCompared) {
    const std::string odd = std::string("\0\x01\xff\"/*\n", 7) + solution(0, "slope");
    const Comparison comparison =
        compareFiles({{"ann", odd}, {"bob", odd}, {"eve", ""}}, {"int stub;\n"}, sandbox_);
    EXPECT_EQ(comparison.compared, 2U);
    ASSERT_EQ(comparison.pairs.size(), 1U);
    EXPECT_EQ(comparison.pairs.front().percent, 100);
    EXPECT_TRUE(compareFiles({}, {}, sandbox_).pairs.empty());
}

TEST_F(SimilarFiles, NoLineThatCompilesHidesACopy) {
    for (const std::string& line :
         {std::string{"#if 0\n\"/*\n#endif\n"}, std::string{"auto t = R\"(\"/*)\";\n"},
          std::string{"// a \\\n\"/*\n"}, std::string{"auto t = \"a\\\n/*\";\n"},
          std::string{"// a \\ \n/*\n"}, std::string{"/\\\n/ /*\n"},
          std::string{"auto t = \"a\\\r\n/*\";\n"}, std::string{"auto t = R\"x()\\\nx\" /*)x\";\n"},
          std::string{"int n = 1'0, m = '/*';\n"}, std::string{"#if __has_include(</*>)\n#endif\n"},
          std::string{"#if 0 // (\n#elif __has_include /**/ (\\\n </*>)\n#endif\n"},
          std::string{"int f(int n) { switch (n) { case'\"': return \"/*\"[0]; } }\n"},
          std::string{"#define $R\nauto t = $R\"(\";\n"},
          std::string{"#define \u00e9R\nauto t = \u00e9R\"(\";\n"}}) {
        const Comparison comparison =
            compareFiles({{"ann", line + solution(0, "slope")}, {"bob", solution(0, "x")}},
                         {line + "int stub;\n"}, sandbox_);
        EXPECT_EQ(comparison.compared, 2U) << line;
        ASSERT_EQ(comparison.pairs.size(), 1U) << line;
        EXPECT_GE(comparison.pairs.front().percent, 95) << line;
    }
}

TEST_F(SimilarFiles, WhatIsInACommentIsNoCode) {
    const std::string comment = "/*\n" + solution(0, "x") + "*/ int n;\n";
    const Comparison comparison =
        compareFiles({{"ann", comment}, {"bob", comment}}, {"int stub;\n"}, sandbox_);
    EXPECT_EQ(comparison.compared, 0U);
}

TEST_F(SimilarFiles, OnlyThePairsThatAreShownHaveTheirPassages) {
    const std::vector<StudentFile> files(21, {"ann", solution(0, "slope")});
    const std::vector<SimilarPair> pairs = compareFiles(files, {"int stub;\n"}, sandbox_).pairs;
    ASSERT_EQ(pairs.size(), 210U);
    EXPECT_FALSE(pairs.at(kMostPairs - 1).passages.empty());
    EXPECT_TRUE(pairs.at(kMostPairs).passages.empty());
}

TEST_F(SimilarFiles, TheMatcherHasLimitsOfItsOwn) {
    const sandbox::Limits& own = sandbox::defaultPolicy().match;
    EXPECT_GT(own.cpuSeconds, sandbox::defaultPolicy().compile.cpuSeconds);
    sandbox::Limits tight = own;
    tight.outputBytes = 1;
    try {
        static_cast<void>(Matcher{sandbox_, tight}.shares({solution(0, "a"), solution(0, "b")}));
        FAIL() << "no limit";
    } catch (const raytracer::Error& error) {
        EXPECT_NE(std::string{error.what()}.find("(stopped after 1 bytes of output)"),
                  std::string::npos)
            << error.what();
    }
}

/// Compares two files where no file may be longer than 16 bytes, in a process of its own.
[[noreturn]] void compareWithoutRoom(const sandbox::Sandbox& sandbox) {
    const rlimit limit{16, 16};
    if (std::signal(SIGXFSZ, SIG_IGN) == SIG_ERR || setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(2);
    alarm(20);
    try {
        static_cast<void>(comparePercentages({{"ann", solution(0, "a")}, {"bob", solution(0, "b")}},
                                             {}, sandbox));
    } catch (const raytracer::Error& error) {
        _exit(std::string{error.what()}.starts_with("cannot write") ? 0 : 3);
    }
    _exit(1);
}

TEST_F(SimilarFiles, AFullDiskIsAnErrorAndNotAClassWithoutPairs) {
    EXPECT_EXIT(compareWithoutRoom(sandbox_), testing::ExitedWithCode(0), "");
}

TEST(PlainLines, HoldCodeAloneInItsLines) {
    const std::vector<std::string> expected{"int   a = 1000; ",
                                            "",
                                            "f(\"\", '0', u8R\"\",",
                                            "",
                                            " xx);",
                                            "#define X",
                                            "abcd",
                                            "",
                                            "+ 1"};
    EXPECT_EQ(
        plainLines("int /* b */ a = 1'000; // c \\\n d\n"
                   "f(\"e // /*\", '\"', u8R\"(\n)\",\n \u00e9);\n#define X\\\n ab\\\ncd\n+ 1"),
        expected);
}

TEST(MatcherFailure, SaysHowTheMatcherEnded) {
    using End = sandbox::Outcome::End;
    const sandbox::Limits limits{.cpuSeconds = 30.0, .wallSeconds = 90.0, .outputBytes = 4096};
    const auto saidOf = [&](End end, int code, const std::string& output = "") {
        sandbox::Outcome outcome;
        outcome.end = end;
        outcome.code = code;
        outcome.output = output;
        return matcherFailure(3, outcome, limits);
    };
    const std::string words = "sim_c++ did not finish on 3 files ";
    EXPECT_EQ(saidOf(End::wallLimit, 0), words + "(stopped after 90 s)");
    EXPECT_EQ(saidOf(End::signalled, SIGXCPU), words + "(stopped after 30 s of the processor)");
    EXPECT_EQ(saidOf(End::signalled, SIGSEGV), words + "(killed by signal 11)");
    EXPECT_EQ(saidOf(End::outputLimit, 0), words + "(stopped after 4096 bytes of output)");
    EXPECT_EQ(saidOf(End::exited, 1, "no memory"), words + "(exit status 1): no memory");
    EXPECT_EQ(saidOf(End::failed, 0, "no uid"), words + "(the sandbox failed): no uid");
}

TEST(SimilarPage, ShowsBothFilesAndEscapesThem) {
    ComparedFile file{"Own.cpp", {{"<b>ann", "a <script>\nb\nc\n"}, {"bob", "b\n"}}, {}};
    file.comparison.pairs = {{0, 1, 62, {{{2, 2}, {1, 1}}}}};
    file.comparison.common = {{{3, 3}}, {}};
    file.comparison.compared = 2;
    const std::string html = similarPage({file});
    EXPECT_EQ(html.find("<script>\n"), std::string::npos);
    EXPECT_EQ(html.find("<b>ann"), std::string::npos);
    EXPECT_NE(html.find("62 %: &lt;b&gt;ann and bob, Own.cpp, 1 passage"), std::string::npos);
    EXPECT_NE(html.find("<span class=\"shared\"> 1    2 b</span>"), std::string::npos) << html;
    EXPECT_NE(html.find("<span class=\"common\">      3 c</span>"), std::string::npos) << html;
    EXPECT_NE(html.find("no proof of copying"), std::string::npos);
    EXPECT_NE(similarJson({file}).find("\"percent\": 62"), std::string::npos);
}

TEST(SimilarPage, NamesFilesThatAreTooLongToBeCompared) {
    ComparedFile file{"Own.cpp", {}, {}};
    EXPECT_EQ(similarPage({file}).find("Too long"), std::string::npos);
    file.leftOut = {"<b>ann", "bob"};
    const std::string html = similarPage({file});
    EXPECT_NE(html.find("Too long to be compared; look at it yourself:</strong> &lt;b&gt;ann, bob"),
              std::string::npos)
        << html;
}

}  // namespace
}  // namespace ticker::similar
