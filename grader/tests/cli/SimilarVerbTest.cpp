#include "GradedClass.h"

#include <grader/similar/Similar.h>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

class SimilarVerb : public GradedClass {};

TEST_F(SimilarVerb, ListsACopyForTickersAloneAndNoOtherPair) {
    if (similar::findMatcher().empty()) GTEST_SKIP() << "similarity-tester is not installed";
    const fs::path solution =
        fs::path{TICKER_SOURCE_DIR} / "grader/corpus/unseen/T1/right/quaternions/BumpySphere.cpp";
    for (const char* name : {"eve", "maximilian"}) {
        fs::create_directory(at("class") / name);
        fs::copy_file(solution, at("class") / name / "BumpySphere.cpp");
    }
    run(gradeCommand("out", {"--quiet"}));
    const auto lines = run({"similar", at("out").string()});
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines.front(), "100 %  BumpySphere.cpp  eve and maximilian");
    const std::string page = textOf(at("out") / "similar.html");
    EXPECT_NE(page.find("100 %: eve and maximilian"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(textOf(at("out") / "similar.json")).size(), 1U);
    run({"report", at("out").string(), "--format", "html", "--quiet"});
    for (const char* file : {"student.html", "report.html"})
        EXPECT_EQ(textOf(at("out") / "eve" / file).find("maximilian"), std::string::npos) << file;
}

TEST_F(SimilarVerb, NamesAFileThatIsTooLongToBeCompared) {
    if (similar::findMatcher().empty()) GTEST_SKIP() << "similarity-tester is not installed";
    run(gradeCommand("out", {"--quiet"}));
    const fs::path padded = at("out") / "ann/code/BumpySphere.cpp";
    ASSERT_TRUE(fs::exists(padded));
    std::ofstream{padded, std::ios::app} << std::string(200'001, ' ');
    run({"similar", at("out").string(), "--quiet"});
    const std::string page = textOf(at("out") / "similar.html");
    EXPECT_NE(page.find("look at it yourself:</strong> ann"), std::string::npos);
    EXPECT_NE(errors().find("left out: BumpySphere.cpp of ann"), std::string::npos);
}

TEST_F(SimilarVerb, NeedsAGradedClass) {
    run({"similar", at("class").string()}, 2);
    run({"similar", at("class").string(), "--least", "0"}, 2);
}

}  // namespace
}  // namespace ticker::cli
