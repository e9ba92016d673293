#include <grader/tasks/FindingTables.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace ticker::tasks {
namespace {

/// The rows of a task; findings that tasks share are among the general ones.
std::string rowsOf(const FindingTable& table) {
    const auto general = findingTables().back().findings;
    const bool isGeneral = table.findings.data() == general.data();
    std::string rows = "| id | meaning |\n|---|---|\n";
    for (const FindingText* text : table.findings)
        if (isGeneral || std::ranges::find(general, text) == general.end())
            rows += "| " + std::string{text->id} + " | " + std::string{text->meaning} + " |\n";
    return rows;
}

std::string headingOf(const FindingTable& table) {
    return "\n## " + std::string{table.heading} + "\n";
}

/// `document` with a fresh table below its heading; a table of a new task comes before the last.
std::string withTable(std::string document, const FindingTable& table) {
    if (document.find(headingOf(table)) == std::string::npos)
        document.insert(document.find(headingOf(findingTables().back())),
                        headingOf(table) + "| id |\n");
    const std::size_t begin = document.find("\n| id |", document.find(headingOf(table))) + 1;
    std::size_t end = begin;
    while (end < document.size() && document[end] == '|')
        end = document.find('\n', end) + 1;
    return document.substr(0, begin) + rowsOf(table) + document.substr(end);
}

/// The lines of either text that the other lacks.
std::string changesBetween(const std::string& written, const std::string& made) {
    const auto linesOf = [](const std::string& text) {
        std::set<std::string> lines;
        std::istringstream in{text};
        for (std::string line; std::getline(in, line);)
            lines.insert(line);
        return lines;
    };
    const std::set<std::string> before = linesOf(written);
    const std::set<std::string> after = linesOf(made);
    std::string changes;
    for (const std::string& line : before)
        if (!after.contains(line)) changes += "- " + line + "\n";
    for (const std::string& line : after)
        if (!before.contains(line)) changes += "+ " + line + "\n";
    return changes.empty() ? "the same rows in another order\n" : changes;
}

TEST(Findings, StandInTheDocumentationAsInTheTables) {
    const std::string written = tests::readFile("docs/findings.md");
    std::string made = written;
    for (const FindingTable& table : findingTables())
        made = withTable(std::move(made), table);
    if (std::getenv("TICKER_WRITE_FINDINGS") != nullptr) {
        std::ofstream{TICKER_SOURCE_DIR "/docs/findings.md", std::ios::binary} << made;
        return;
    }
    EXPECT_TRUE(written == made) << "docs/findings.md is to change as follows:\n"
                                 << changesBetween(written, made)
                                 << "TICKER_WRITE_FINDINGS=1 ./tick test -R findings writes it";
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
