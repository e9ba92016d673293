// Links between the project's own files lead somewhere.
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace ticker {
namespace {

namespace fs = std::filesystem;

const fs::path kProject = TICKER_SOURCE_DIR;

/// The lines of a document outside code blocks.
std::vector<std::string> proseOf(const fs::path& file) {
    std::istringstream lines{tests::readFile(file.lexically_relative(kProject).string())};
    std::vector<std::string> prose;
    bool inCode = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) inCode = !inCode;
        if (!inCode) prose.push_back(line);
    }
    return prose;
}

/// The name that GitHub gives to a heading: "Level B, C" -> "level-b-c".
std::string anchorOf(const std::string& heading) {
    std::string anchor;
    for (const char c : heading) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || c == '-' || c == '_')
            anchor += static_cast<char>(std::tolower(byte));
        if (c == ' ') anchor += '-';
    }
    return anchor;
}

std::set<std::string> anchorsIn(const fs::path& file) {
    static const std::regex kHeading{"#+ (.*)"};
    std::set<std::string> anchors;
    for (const std::string& line : proseOf(file)) {
        std::smatch match;
        if (std::regex_match(line, match, kHeading)) anchors.insert(anchorOf(match[1]));
    }
    return anchors;
}

std::vector<std::string> linksIn(const fs::path& file) {
    static const std::regex kLink{R"(\]\(([^) ]+)\))"};
    std::vector<std::string> links;
    for (const std::string& line : proseOf(file))
        for (std::sregex_iterator at{line.begin(), line.end(), kLink}; at != std::sregex_iterator{};
             ++at)
            links.push_back((*at)[1]);
    return links;
}

TEST(Links, LeadToFilesAndHeadingsThatAreThere) {
    int checked = 0;
    for (const fs::path& document : tests::documents())
        for (const std::string& link : linksIn(document)) {
            if (link.find(':') != std::string::npos) continue;  // the web
            const std::size_t hash = link.find('#');
            const fs::path target =
                hash == 0 ? document : document.parent_path() / link.substr(0, hash);
            EXPECT_TRUE(fs::exists(target)) << document << ": " << link;
            const bool hasAnchor = hash != std::string::npos && fs::exists(target);
            EXPECT_TRUE(!hasAnchor || anchorsIn(target).contains(link.substr(hash + 1)))
                << document << ": " << link;
            ++checked;
        }
    EXPECT_GT(checked, 40);
}

TEST(Pictures, AreDescribedInWords) {
    for (const fs::path& document : tests::documents())
        for (const std::string& line : proseOf(document))
            EXPECT_EQ(line.find("![]("), std::string::npos) << document << ": " << line;
}

TEST(Pictures, InDocsAreAllShown) {
    std::set<std::string> shown;
    for (const fs::path& document : tests::documents())
        for (const std::string& link : linksIn(document))
            shown.insert((document.parent_path() / link).lexically_normal().filename());
    for (const fs::directory_entry& picture : fs::directory_iterator{kProject / "docs/images"})
        EXPECT_TRUE(shown.contains(picture.path().filename())) << picture.path();
}

}  // namespace
}  // namespace ticker
