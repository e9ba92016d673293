#include <grader/result/GeneralFindings.h>
#include <grader/tasks/AllFindings.h>
#include <grader/tasks/bump/BumpFindings.h>
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/screenshot/ScreenshotFindings.h>
#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <span>
#include <string>

namespace ticker::tasks {
namespace {

using Table = std::span<const FindingText* const>;

/// The rows of a task; findings that tasks share are among the general ones.
std::string rowsOf(Table table) {
    const bool isGeneral = table.data() == kGeneralFindings.data();
    std::string rows = "| id | meaning |\n|---|---|\n";
    for (const FindingText* text : table)
        if (isGeneral || text != &kSettingsHardCoded)
            rows += "| " + std::string{text->id} + " | " + std::string{text->meaning} + " |\n";
    return rows;
}

/// `document` with a fresh table below `heading`.
std::string withTable(const std::string& document, const std::string& heading, Table table) {
    const std::size_t begin =
        document.find("\n| id |", document.find("\n## " + heading + "\n")) + 1;
    std::size_t end = begin;
    while (end < document.size() && document[end] == '|')
        end = document.find('\n', end) + 1;
    return document.substr(0, begin) + rowsOf(table) + document.substr(end);
}

TEST(Findings, StandInTheDocumentationAsInTheTables) {
    const std::string written = tests::readFile("docs/findings.md");
    std::string made = withTable(written, "T1", kBumpFindings);
    made = withTable(made, "T2.1", kShadowFindings);
    made = withTable(made, "T2.2", kLensFindings);
    made = withTable(made, "Screenshot", kScreenshotFindings);
    made = withTable(made, "Any task", kGeneralFindings);
    if (std::getenv("TICKER_WRITE_FINDINGS") != nullptr)
        std::ofstream{TICKER_SOURCE_DIR "/docs/findings.md", std::ios::binary} << made;
    EXPECT_EQ(written, made) << "TICKER_WRITE_FINDINGS=1 build/release/bin/test_findings writes it";
}

TEST(Findings, HaveAnIdOfTheirOwnWordsAndAMeaning) {
    std::set<std::string_view> ids;
    for (const FindingText* text : allFindings()) {
        EXPECT_TRUE(ids.insert(text->id).second) << text->id;
        EXPECT_FALSE(text->words.empty()) << text->id;
        EXPECT_FALSE(text->meaning.empty()) << text->id;
        EXPECT_EQ(findText(text->id), text);
    }
    EXPECT_GT(ids.size(), 70U);
    EXPECT_EQ(findText("shadow.harsh"), nullptr);
}

}  // namespace
}  // namespace ticker::tasks
