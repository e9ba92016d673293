// There is one handout, docs/handout.md, with one numbering: texts cite only its equations, figures
// and constants.
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

const fs::path kCheckout = TICKER_SOURCE_DIR;

/// True for students' texts, which may name anything, and for this test.
bool isForeign(const std::string& name) {
    for (const char* folder :
         {"grader/tests/docs/", "grader/corpus/unseen/", "grader/corpus/hostile/cases/"})
        if (name.starts_with(folder)) return true;
    return name.starts_with("grader/corpus/samples/") && name.ends_with(".cpp");
}

/// The project's texts: documents, figures, comments, messages.
std::vector<std::string> texts() {
    static const std::set<std::string> kKinds{".md",  ".svg",  ".cpp", ".h",
                                              ".txt", ".json", ".awk", ".xml"};
    std::vector<std::string> found;
    for (const char* folder :
         {"docs", "grader", "reference_solution", "scenes", "student_template", "tools"})
        for (const fs::directory_entry& entry :
             fs::recursive_directory_iterator{kCheckout / folder}) {
            const std::string name = entry.path().lexically_relative(kCheckout);
            if (entry.is_regular_file() && kKinds.contains(entry.path().extension()) &&
                !isForeign(name))
                found.push_back(name);
        }
    for (const char* name : {"README.md", "CONTRIBUTING.md"})
        found.emplace_back(name);
    return found;
}

/// The first match in a text, with the preceding part of its line; empty without a match.
std::string firstIn(const std::string& text, const std::regex& wanted) {
    std::smatch match;
    return std::regex_search(text, match, wanted) ? match.str() : "";
}

/// The equation numbers of the handout, which are at the ends of lines.
std::set<std::string> equationsOfTheHandout() {
    static const std::regex kNumber{R"( {4}.*\(([0-9]+)\))"};
    std::set<std::string> numbers;
    std::istringstream lines{tests::readFile("docs/handout.md")};
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_match(line, match, kNumber)) numbers.insert(match[1]);
    }
    return numbers;
}

TEST(Texts, NameNoConstantThatTheHandoutDoesNotName) {
    static const std::regex kConstant{
        "BUMP_FACTOR|SHADOW_RAY_COUNT|LIGHT_SIZE|DOF_(RAY_COUNT|FOCAL_PLANE|AMOUNT)"};
    for (const std::string& name : texts())
        EXPECT_EQ(firstIn(tests::readFile(name), kConstant), "") << name;
}

TEST(Texts, CiteEquationsThatTheHandoutHas) {
    const std::set<std::string> known = equationsOfTheHandout();
    ASSERT_EQ(known, (std::set<std::string>{"1", "2", "3"}));
    static const std::regex kCited{R"(Equations? \(([0-9])\)(?:,? (?:to|and|or) \(([0-9])\))?)"};
    int cited = 0;
    for (const std::string& name : texts()) {
        const std::string text = tests::readFile(name);
        for (std::sregex_iterator at{text.begin(), text.end(), kCited};
             at != std::sregex_iterator{}; ++at)
            for (const std::size_t group : {1U, 2U}) {
                const std::string number = (*at)[group];
                EXPECT_TRUE(number.empty() || known.contains(number)) << name << ": " << at->str();
                ++cited;
            }
    }
    EXPECT_GT(cited, 4);
}

// Equation (1) has neither cross products nor signs to choose; it is right as printed.
TEST(Texts, AscribeNoMistakeOrCrossProductToEquationOne) {
    static const std::regex kWrong{
        R"(Equation \(1\)[^.;]{0,90}(litera|printed|inverts|cross|n x |Bu goes))"};
    for (const std::string& name : texts())
        EXPECT_EQ(firstIn(tests::readFile(name), kWrong), "") << name;
}

TEST(Texts, CiteNoFigureByNumber) {
    static const std::regex kFigure{R"([Hh]andout[^.]{0,40}Figure [0-9]|Figure [0-9]+[ab])"};
    for (const std::string& name : texts())
        EXPECT_EQ(firstIn(tests::readFile(name), kFigure), "") << name;
}

}  // namespace
}  // namespace ticker
