#include "GradedClass.h"

namespace ticker::cli {
namespace {

class Appeal : public GradedClass {};

TEST_F(Appeal, GradesAResultAgainWithTheSameQuestionsAndWithFreshOnes) {
    run(gradeCommand("out", {"--quiet"}));
    const std::string page = textOf(at("out") / "=1+1" / "student.html");
    const std::string words = "tell the course staff its number: ";
    ASSERT_NE(page.find(words), std::string::npos);
    const std::string number = page.substr(page.find(words) + words.size(), 9);
    const auto lines = run({"appeal", number, at("out").string()});
    ASSERT_EQ(lines.size(), 5U);
    for (const std::size_t line : {0U, 1U, 3U})
        EXPECT_NE(lines[line].find("bump.inverted-u"), std::string::npos) << lines[line];
    const auto seedIn = [&](const std::string& folder) {
        return nlohmann::json::parse(textOf(at("out") / "=1+1" / folder / "result.json"))
            .at("seed")
            .get<std::string>();
    };
    EXPECT_EQ(seedIn("appeal/same-questions/=1+1"), seedIn("."));
    EXPECT_NE(seedIn("appeal/fresh-questions/=1+1"), seedIn("."));
    run({"appeal", "0000-0000", at("out").string()}, 2);
    EXPECT_NE(errors().find("0 of its results have the number 0000-0000"), std::string::npos);
}

}  // namespace
}  // namespace ticker::cli
