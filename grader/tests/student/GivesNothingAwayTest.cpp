#include <grader/base/WholeFile.h>
#include <grader/corpus/Entry.h>
#include <grader/tests/student/UnpackedPackage.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace ticker {
namespace {

namespace fs = std::filesystem;

std::string withoutSpace(const std::string& text) {
    std::string packed;
    std::ranges::copy_if(text, std::back_inserter(packed),
                         [](unsigned char c) { return std::isspace(c) == 0; });
    return packed;
}

/// Adds the statements that are long enough to recognise a copy.
void addStatements(const std::string& code, std::set<std::string>& statements) {
    constexpr std::size_t kLong = 30;
    std::istringstream lines{code};
    for (std::string line; std::getline(lines, line);) {
        const std::string packed = withoutSpace(line.substr(0, line.find("//")));
        if (packed.size() >= kLong) statements.insert(packed);
    }
}

/// The text between a file's marks.
std::string betweenMarks(const std::string& text, const std::string& task) {
    const std::size_t from = text.find("// TASK " + task + " begin");
    const std::size_t to = text.find("// TASK " + task + " end");
    return text.substr(from, to - from);
}

/// The framework's text without white space; some mistakes repeat parts of it.
std::string frameworkText() {
    std::string text;
    const fs::path folder = fs::path{TICKER_SOURCE_DIR} / "student_template/framework/src";
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder})
        if (entry.is_regular_file()) text += withoutSpace(readWhole(entry.path()));
    return text;
}

/// Lines of the model answer and of the mistakes made from it, except lines of the stubs and the
/// framework.
std::set<std::string> secretStatements() {
    std::set<std::string> secret;
    std::set<std::string> known;
    for (const auto& [file, tasks] : std::map<std::string, std::vector<std::string>>{
             {"BumpySphere.cpp", {"T1"}}, {"Renderer.cpp", {"T2.1", "T2.2"}}}) {
        for (const std::string& task : tasks)
            addStatements(
                betweenMarks(tests::readFile("reference_solution/exercise/" + file), task), secret);
        addStatements(tests::readFile("student_template/exercise/" + file), known);
    }
    const std::string framework = frameworkText();
    for (const std::string& answer : secret)
        EXPECT_EQ(framework.find(answer), std::string::npos) << answer;
    for (const corpus::Entry& mistake : corpus::readCatalogue(TICKER_SOURCE_DIR))
        for (const corpus::Edit& edit : mistake.edits.at(mistake.file()))
            addStatements(edit.replace, secret);
    for (const std::string& statement : known)
        secret.erase(statement);
    std::erase_if(secret, [&](const std::string& statement) {
        return framework.find(statement) != std::string::npos;
    });
    return secret;
}

class StudentPackage : public ::testing::Test {
protected:
    static const tests::UnpackedPackage& package() {
        static const tests::UnpackedPackage unpacked;
        return unpacked;
    }

    static std::map<std::string, std::string> contents() {
        std::map<std::string, std::string> texts;
        for (const fs::path& file : package().files())
            texts[fs::relative(file, package().folder()).string()] = readWhole(file);
        return texts;
    }
};

TEST_F(StudentPackage, HoldsWhatAStudentNeeds) {
    const auto texts = contents();
    for (const char* name : {"README.md",
                             "check",
                             "check.cmd",
                             "CMakeLists.txt",
                             "CMakePresets.json",
                             "vcpkg.json",
                             "exercise/BumpySphere.cpp",
                             "exercise/Renderer.cpp",
                             "framework/app/main.cpp",
                             "tests/bump/SlopesTest.cpp",
                             "tests/shadows/RaysTest.cpp",
                             "tests/lens/FocusTest.cpp",
                             "scenes/bump-mapping.xml",
                             "scenes/distributed.xml",
                             "scenes/bumpmap-test.xml",
                             "assets/bumpmap.png",
                             "assets/bumpmap-test.png",
                             ".vscode/settings.json",
                             ".clangd",
                             ".gitattributes",
                             ".gitignore",
                             ".devcontainer/Dockerfile",
                             "LICENSE"})
        EXPECT_TRUE(texts.contains(name)) << name;
    EXPECT_EQ(fs::exists(fs::path{TICKER_SOURCE_DIR} / "docs/handout.md"),
              texts.contains("handout.md"));
    EXPECT_NE(fs::status(package().folder() / "check").permissions() & fs::perms::owner_exec,
              fs::perms::none);
}

TEST_F(StudentPackage, HoldsNoLineOfTheAnswersOrOfTheMistakes) {
    const std::set<std::string> secret = secretStatements();
    ASSERT_GT(secret.size(), 100U);
    for (const auto& [name, text] : contents()) {
        if (name.ends_with(".png")) continue;
        const std::string packed = withoutSpace(text);
        for (const std::string& statement : secret)
            EXPECT_EQ(packed.find(statement), std::string::npos) << name << ": " << statement;
    }
}

TEST_F(StudentPackage, NamesNothingOfTheGrader) {
    for (const auto& [name, text] : contents()) {
        if (name.ends_with(".png")) continue;
        for (const char* word :
             {"reference_solution", "tick1star-reference", "<grader/", "grader/corpus/mistakes",
              "namespace ticker", "bump.inverted", "shadow.hard", "dof.none", "expected.json"})
            EXPECT_EQ(text.find(word), std::string::npos) << name << " says " << word;
    }
}

TEST_F(StudentPackage, HoldsNoReferencePicture) {
    const fs::path references = fs::path{TICKER_SOURCE_DIR} / "assets/references";
    std::set<std::string> secret;
    if (fs::is_directory(references))
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator{references})
            if (entry.is_regular_file()) secret.insert(readWhole(entry.path()));
    for (const auto& [name, bytes] : contents()) {
        EXPECT_FALSE(secret.contains(bytes)) << name;
        EXPECT_EQ(name.find("references"), std::string::npos) << name;
    }
}

}  // namespace
}  // namespace ticker
