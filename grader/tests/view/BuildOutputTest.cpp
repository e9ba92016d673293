#include <student_template/framework/app/view/BuildOutput.h>

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace raytracer::view {
namespace {

TestOutcome testOutcomeIn(const std::string& output, const std::set<std::string>& tasks) {
    TestReader reader{tasks};
    reader.add(output);
    return reader.outcome();
}

TEST(BuildOutput, KnowsTheTasksOfTheMainTick) {
    const TestOutcome outcome = testOutcomeIn(
        "NOT YET: M3.2 A ball before the light shades\n  got:      1\n\nM1   spheres: 4 of 4\n",
        {});
    EXPECT_EQ(outcome.title, "M3.2 A ball before the light shades");
    EXPECT_EQ(outcome.summary, "M1   spheres: 4 of 4\n");
}

TEST(BuildOutput, FindsTheFirstErrorOfEveryCompiler) {
    for (const std::string text :
         {"[1/2] Building\n/a/exercise/Renderer.cpp:44:18: error: expected ';'\nx.h:1: error: no\n",
          "/a/exercise/Renderer.cpp:44:18: fatal error: expected ';'\r\n",
          "/a/exercise/Renderer.cpp(44,18): error C2143: expected ';'\n",
          "/a/exercise/Renderer.cpp(44): error C2143: expected ';'\n"}) {
        const auto error = firstErrorIn(text);
        ASSERT_TRUE(error) << text;
        EXPECT_EQ(error->file, "/a/exercise/Renderer.cpp") << text;
        EXPECT_EQ(error->line, 44) << text;
        EXPECT_EQ(error->message, "expected ';'") << text;
    }
}

TEST(BuildOutput, FindsWhatALinkerMisses) {
    const auto error =
        firstErrorIn("ld: a.o: in function f:\na.cpp: undefined reference to `g()'\n");
    ASSERT_TRUE(error);
    EXPECT_TRUE(error->file.empty());
    EXPECT_NE(error->message.find("undefined reference to `g()'"), std::string::npos);
}

TEST(BuildOutput, TakesNoWarningForAnError) {
    EXPECT_FALSE(firstErrorIn("a.cpp:3:1: warning: unused variable 'error'\nninja: done\n"));
    EXPECT_FALSE(firstErrorIn(std::string(1'000'000, 'x')));
}

constexpr const char* kOutput =
    "NOT YET: T1   Normals have unit length\n  expected: 1\n  got:      2\n\n"
    "NOT YET: T2.1 Shadows are soft\n  expected: a share\n\n"
    "NOT YET: T2.1 Another\n  expected: b\n\n"
    "T1   bump mapping:   10 of 11 public tests passed\n"
    "T2.1 soft shadows:   9 of 11 public tests passed\n"
    "T2.2 depth of field: not attempted\n";

TEST(BuildOutput, TellsTheFirstFailingTestOfTheTasksInTheFile) {
    const TestOutcome outcome = testOutcomeIn(kOutput, {"T2.1", "T2.2"});
    EXPECT_TRUE(outcome.hasFailed);
    EXPECT_EQ(outcome.title, "T2.1 Shadows are soft");
    EXPECT_EQ(outcome.text, "  expected: a share\n");
    EXPECT_EQ(outcome.summary.find("T1 "), std::string::npos);
    EXPECT_NE(outcome.summary.find("T2.2 depth of field: not attempted"), std::string::npos);
    EXPECT_EQ(testOutcomeIn(kOutput, {}).title, "T1   Normals have unit length");
    EXPECT_FALSE(testOutcomeIn(kOutput, {"T2.2"}).hasFailed);
    EXPECT_EQ(
        testOutcomeIn(std::string{"NOT YET: T2.2 Later\n  a\n\n"} + kOutput, {"T2.1", "T2.2"}).text,
        "  expected: a share\n");
}

TEST(BuildOutput, TellsWhichTaskEndedTooEarly) {
    TestReader reader{{}};
    reader.addEarlyEnd("T1", "ended too early", "what it wrote\n");
    reader.add("NOT YET: T2.1 Shadows are soft\n  expected: a share\n\n");
    EXPECT_TRUE(reader.outcome().hasFailed);
    EXPECT_EQ(reader.outcome().title, "T1 ended too early");
    EXPECT_EQ(reader.outcome().text, "what it wrote\n");
    EXPECT_EQ(reader.outcome().summary, "T1 ended too early\n");
}

TEST(BuildOutput, KnowsTheTasksOfAFileByItsMarks) {
    EXPECT_EQ(
        tasksIn("int a;\n    // TASK T2.1 begin\n    // TASK T2.1 end\n//TASK T2.2 begin\r\n"),
        (std::set<std::string>{"T2.1", "T2.2"}));
    EXPECT_TRUE(tasksIn("// the TASK begins\n").empty());
}

}  // namespace
}  // namespace raytracer::view
