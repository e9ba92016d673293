#include <grader/result/AppealNumber.h>
#include <grader/result/ResultJson.h>

#include "GradedClass.h"

#include <map>
#include <utility>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

class Appeal : public GradedClass {
protected:
    [[nodiscard]] std::string numberOf(const std::string& name) const {
        const std::string page = textOf(at("out") / name / "student.html");
        const std::string words = "tell the course staff its number: ";
        const std::size_t found = page.find(words);
        return found == std::string::npos ? "none" : page.substr(found + words.size(), 9);
    }
    [[nodiscard]] std::vector<std::string> appealCommand(
        const std::string& name, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"appeal", numberOf(name), at("out").string()};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    [[nodiscard]] nlohmann::json resultIn(const std::string& folder) const {
        return untimed(at("out") / "=1+1" / folder / "result.json");
    }
};

TEST_F(Appeal, GradesAResultAgainWithTheSameQuestionsAndWithFreshOnes) {
    run(gradeCommand("out", {"--quiet"}));
    const auto lines = run(appealCommand("=1+1"));
    ASSERT_EQ(lines.size(), 5U);
    for (const std::size_t line : {0U, 1U, 3U})
        EXPECT_NE(lines[line].find("bump.inverted-u"), std::string::npos) << lines[line];
    const nlohmann::json first = resultIn(".");
    const nlohmann::json same = resultIn("appeal/same-questions/=1+1");
    const nlohmann::json fresh = resultIn("appeal/fresh-questions/=1+1");
    EXPECT_EQ(same.at("seed"), first.at("seed"));
    EXPECT_NE(fresh.at("seed"), first.at("seed"));
    EXPECT_EQ(same.at("tasks"), first.at("tasks")) << "measured values show what was asked";
    EXPECT_NE(fresh.at("tasks"), first.at("tasks"));
    EXPECT_EQ(errors(), "") << "the same ticker graded it";
    run({"appeal", "0000-0000", at("out").string()}, 2);
    EXPECT_NE(errors().find("0 of its results have the number 0000-0000"), std::string::npos);
}

TEST_F(Appeal, HasTheScreenshotAsItWasHandedInAndNotTheOneThatPagesShow) {
    run(gradeCommand("out", {"--quiet"}));
    const fs::path folder = at("out") / "=1+1";
    const std::string handedIn = textOf(at("class") / "=1+1" / "screenshot.png");
    EXPECT_TRUE(textOf(folder / "handed-in" / "screenshot.png") == handedIn);
    EXPECT_FALSE(textOf(folder / "images" / "screenshot.png") == handedIn);
    for (const char* page : {"report.html", "student.html", "../index.html"})
        EXPECT_EQ(textOf(folder / page).find("handed-in/"), std::string::npos) << page;

    fs::remove(at("class") / "=1+1" / "screenshot.png");
    run(gradeCommand("out", {"--quiet", "--resume"}));
    EXPECT_TRUE(fs::is_empty(folder / "handed-in")) << "none was handed in";

    fs::remove(folder / "handed-in");
    EXPECT_EQ(run(appealCommand("=1+1"), 2).size(), 0U);
    EXPECT_NE(errors().find("does not hold all that was handed in"), std::string::npos) << errors();
    EXPECT_NE(errors().find("--seed"), std::string::npos) << errors();
}

TEST_F(Appeal, JudgesAsTheFirstResultWasJudged) {
    run(gradeCommand("out", {"--quiet", "--option", "T1"}));
    EXPECT_EQ(run(appealCommand("=1+1"), 2).size(), 0U);
    EXPECT_NE(errors().find("another --rubric or --option"), std::string::npos) << errors();
    EXPECT_EQ(run(appealCommand("=1+1", {"--option", "T1", "--sandbox", "b"}), 2).size(), 0U);
    EXPECT_NE(errors().find("--sandbox"), std::string::npos) << errors();
    EXPECT_EQ(run(appealCommand("=1+1", {"--option", "T1"})).size(), 5U);
}

/// Two submissions whose results have the same number.
std::pair<SubmissionResult, SubmissionResult> withOneNumber() {
    std::map<std::string, SubmissionResult> byNumber;
    for (int i = 0;; ++i) {
        SubmissionResult result;
        result.submission = "ann " + std::to_string(i);
        const auto [found, isNew] = byNumber.try_emplace(appealNumber(result), result);
        if (!isNew) return {found->second, result};
    }
}

TEST_F(Appeal, AsksWhichOneIsMeantWhereTwoHaveTheNumber) {
    const auto [one, other] = withOneNumber();
    for (const SubmissionResult& result : {one, other}) {
        fs::create_directories(at("out") / result.submission);
        std::ofstream{at("out") / result.submission / "result.json"} << resultJson(result);
    }
    const std::vector<std::string> command{"appeal", appealNumber(one), at("out").string()};
    run(command, 2);
    EXPECT_NE(errors().find("2 of its results have the number"), std::string::npos) << errors();
    EXPECT_NE(errors().find("--submission"), std::string::npos) << errors();
    for (const SubmissionResult& result : {one, other}) {
        EXPECT_NE(errors().find(result.submission), std::string::npos) << errors();
    }
    for (const SubmissionResult& result : {one, other}) {
        std::vector<std::string> chosen = command;
        chosen.insert(chosen.end(), {"--submission", result.submission});
        run(chosen, 2);
        EXPECT_NE(errors().find(result.submission + ": does not hold all that was handed in"),
                  std::string::npos)
            << errors();
    }
    std::vector<std::string> nobody = command;
    nobody.insert(nobody.end(), {"--submission", "nobody"});
    run(nobody, 2);
    EXPECT_NE(errors().find("0 of its results of nobody have the number"), std::string::npos)
        << errors();
}

TEST_F(Appeal, RefusesWhatIntakeRefused) {
    fs::copy(fs::path{TICKER_SOURCE_DIR} / "grader/corpus/samples/needsReview/two-versions",
             at("class") / "two", fs::copy_options::recursive);
    run(gradeCommand("out", {"--quiet"}));
    const auto lines = run(appealCommand("two"));
    ASSERT_EQ(lines.size(), 5U);
    for (const std::size_t line : {0U, 1U, 3U}) {
        EXPECT_NE(lines[line].find("needsReview"), std::string::npos) << lines[line];
        EXPECT_NE(lines[line].find("intake.ambiguous"), std::string::npos) << lines[line];
    }
}

}  // namespace
}  // namespace ticker::cli
