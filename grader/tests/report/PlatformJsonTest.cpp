#include <grader/report/platforms/PlatformFormats.h>
#include <grader/tests/support/FitsSchema.h>

#include "ExampleResults.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>
#include <string>
#include <vector>

namespace ticker::report {
namespace {

using nlohmann::json;

StudentView viewOf(const SubmissionResult& result) {
    return {result, {}};
}

TEST(GradescopeJson, FitsItsSchemaWhateverIsInTheResult) {
    for (const SubmissionResult& result : exampleClass(5)) {
        const auto text = gradescopeJson(viewOf(result));
        ASSERT_TRUE(text) << result.submission;
        EXPECT_TRUE(tests::fitsSchema(*text, "gradescope")) << *text;
    }
    json wrong = json::parse(*gradescopeJson(viewOf(passedExample())));
    wrong["tests"][0]["status"] = "fine";
    EXPECT_FALSE(tests::fitsSchema(wrong.dump(), "gradescope"));
}

TEST(GradescopeJson, HasTheScoreAndOneVisibleTestForEachTaskWorkedOn) {
    const json passed = json::parse(*gradescopeJson(viewOf(passedExample())));
    EXPECT_EQ(passed["score"], 1.0);
    EXPECT_EQ(passed["tests"].size(), 4U);
    const json failed = json::parse(*gradescopeJson(viewOf(failedBumpExample())));
    EXPECT_EQ(failed["score"], 0.0);
    ASSERT_EQ(failed["tests"].size(), 2U) << "T2 was not attempted";
    EXPECT_EQ(failed["tests"][0]["name"], "T1 Bump mapping");
    EXPECT_EQ(failed["tests"][0]["status"], "failed");
    for (const json& test : failed["tests"]) {
        EXPECT_EQ(test["visibility"], "visible") << "a hidden test hides the score";
        EXPECT_FALSE(test.contains("score")) << "the rubric's score is no sum";
    }
}

TEST(GradescopeJson, IsMissingRatherThanAScoreWhereWeFailed) {
    EXPECT_FALSE(gradescopeJson(viewOf(notGradedExample())));
}

TEST(PrairieLearnJson, FitsItsSchemaWhateverIsInTheResult) {
    for (const SubmissionResult& result : exampleClass(5))
        EXPECT_TRUE(tests::fitsSchema(prairieLearnJson(viewOf(result)), "prairielearn"));
    EXPECT_TRUE(tests::fitsSchema(prairieLearnJson(viewOf(notGradedExample())), "prairielearn"));
    EXPECT_FALSE(tests::fitsSchema(R"({"gradable": true})", "prairielearn"));
    EXPECT_FALSE(tests::fitsSchema(R"({"gradable": false, "score": 1})", "prairielearn"));
}

TEST(PrairieLearnJson, IsNotGradableWhereWeFailed) {
    EXPECT_EQ(json::parse(prairieLearnJson(viewOf(notGradedExample())))["gradable"], false);
    const json passed = json::parse(prairieLearnJson(viewOf(passedExample())));
    EXPECT_EQ(passed["gradable"], true);
    EXPECT_EQ(passed["score"], 1.0);
}

TEST(PrairieLearnJson, ScoreIsAShareWhateverTheRubricsPoints) {
    SubmissionResult result = passedExample();
    result.score = 15.0;
    result.maxScore = 20.0;
    EXPECT_DOUBLE_EQ(json::parse(prairieLearnJson(viewOf(result)))["score"].get<double>(), 0.75);
}

TEST(ClassroomJson, BothWaysOfAddingUpPointsAgree) {
    for (const SubmissionResult& result : exampleClass(5)) {
        const std::string text = classroomJson(viewOf(result));
        EXPECT_TRUE(tests::fitsSchema(text, "classroom"));
        const json document = json::parse(text);
        double sum = 0.0;
        double passed = 0.0;
        for (const json& test : document["tests"]) {
            sum += test["score"].get<double>();
            passed += test["status"] == "pass" ? 1.0 : 0.0;
        }
        EXPECT_DOUBLE_EQ(sum, passed / static_cast<double>(document["tests"].size()) *
                                  document["max_score"].get<double>());
    }
    EXPECT_EQ(json::parse(classroomJson(viewOf(notGradedExample())))["status"], "error");
}

TEST(AutolabLines, TheLastLineIsTheScore) {
    std::istringstream stream{autolabLines(viewOf(passedExample()))};
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    ASSERT_GT(lines.size(), 2U);
    EXPECT_EQ(lines.back(), R"({"scores":{"Tick":1.0}})");
    const json feedback = json::parse(lines[lines.size() - 2]);
    EXPECT_EQ(feedback["_presentation"], "semantic");
    EXPECT_EQ(feedback["Tick"]["T1 Bump mapping"]["passed"], true);
    EXPECT_TRUE(feedback["Tick"]["T2.1 Soft shadows"].contains("hint"));
}

TEST(GitHubAnnotations, StandAtTheCompilersLinesAndAtTheTasks) {
    SubmissionResult result = failedBumpExample();
    result.diagnostics = {{"Renderer.cpp", "Renderer.cpp:7:3: error: expected ';'\n  7 | a\n"}};
    const std::string text = gitHubAnnotations(StudentView{result, {}}).value();
    EXPECT_NE(text.find("::error file=exercise/Renderer.cpp,line=7,title=The compiler::expected "
                        "';'\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("::error file=exercise/BumpySphere.cpp,line={T1},title=T1 Bump mapping::"),
              std::string::npos)
        << text;
    EXPECT_FALSE(gitHubAnnotations(viewOf(notGradedExample())));
}

TEST(GitHubAnnotations, HoldNoCommandOfAStudents) {
    SubmissionResult result = hostileExample();
    result.diagnostics = {
        {"Renderer.cpp", "Renderer.cpp:7:3: error: a%0A::stop-commands::x\r::b\n"}};
    const std::string text = gitHubAnnotations(StudentView{result, {}}).value();
    std::istringstream lines{text};
    for (std::string line; std::getline(lines, line);) {
        EXPECT_EQ(line.find('\r'), std::string::npos) << line;
        EXPECT_TRUE(line.starts_with("::error file=exercise/") ||
                    line.starts_with("::warning file=exercise/") ||
                    line.starts_with("::notice file=exercise/"))
            << line;
    }
    EXPECT_NE(text.find("::a%250A::stop-commands::x%0D::b\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace ticker::report
