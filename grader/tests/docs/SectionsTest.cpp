// Sections of the handouts that findings and public tests name exist.
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace ticker {
namespace {

namespace fs = std::filesystem;

const fs::path kTopFolder = TICKER_SOURCE_DIR;

std::set<std::string> headings() {
    std::set<std::string> found;
    for (const char* handout : {"docs/handout.md", "docs/handout-tick1.md"}) {
        std::istringstream lines{tests::readFile(handout)};
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with("## ") || line.starts_with("### "))
                found.insert(line.substr(line.find(' ') + 1));
    }
    return found;
}

/// The sections in "Option 1: The sign trap; What to do, step 3".
std::vector<std::string> sectionsIn(std::string text) {
    const std::string option = "Option 1: ";
    if (text.starts_with(option)) text.erase(0, option.size());
    static const std::regex kStep{", steps? [^;]*"};
    std::istringstream parts{std::regex_replace(text, kStep, "")};
    std::vector<std::string> sections;
    for (std::string part; std::getline(parts, part, ';');)
        sections.push_back(part.substr(part.find_first_not_of(' ')));
    return sections;
}

TEST(Sections, OfTheHandoutThatMessagesNameAreThere) {
    const std::set<std::string> known = headings();
    static const std::regex kCited{
        R"re("((Option 1: |[0-9], [A-Z]|Soft shadows \(T|Depth of field \(T|[A-Z][a-z]+( [a-z]+)? \(M|Test and submit)[^"]*)")re"};
    int cited = 0;
    for (const char* folder : {"grader/tasks", "grader/intake", "grader/pipeline", "grader/build",
                               "student_template/tests"})
        for (const fs::directory_entry& entry :
             fs::recursive_directory_iterator{kTopFolder / folder}) {
            if (!entry.is_regular_file()) continue;
            const std::string text =
                tests::readFile(entry.path().lexically_relative(kTopFolder).string());
            for (std::sregex_iterator at{text.begin(), text.end(), kCited};
                 at != std::sregex_iterator{}; ++at, ++cited)
                for (const std::string& section : sectionsIn((*at)[1]))
                    EXPECT_TRUE(known.contains(section)) << entry.path() << ": " << (*at)[1];
        }
    EXPECT_GT(cited, 50);
}

}  // namespace
}  // namespace ticker
