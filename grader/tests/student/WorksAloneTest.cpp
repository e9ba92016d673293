#include <grader/tests/student/UnpackedPackage.h>
#include <grader/tests/support/Files.h>
#include <grader/tests/support/ShellBlocks.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace ticker {
namespace {

namespace fs = std::filesystem;

// One package and one build for all tests, which go on from one another as a student does: each
// begins by putting its own two files there.
class PackageAlone : public ::testing::Test {
protected:
    static const tests::UnpackedPackage& package() {
        static const tests::UnpackedPackage unpacked;
        return unpacked;
    }

    /// Writes both files, from a folder of the project.
    static void putSolution(const std::string& folder) {
        put("BumpySphere.cpp", tests::readFile(folder + "/BumpySphere.cpp"));
        put("Renderer.cpp", tests::readFile(folder + "/Renderer.cpp"));
    }

    static void put(const std::string& name, const std::string& text) {
        std::ofstream{package().folder() / "exercise" / name} << text;
    }
};

TEST_F(PackageAlone, SaysThatNothingIsAttemptedAndRendersAtOnce) {
    putSolution("student_template/exercise");
    const tests::CommandResult checked = package().runAlone("./check");

    EXPECT_EQ(checked.status, 0) << checked.output;
    for (const char* line :
         {"T1   bump mapping:   not attempted", "T2.1 soft shadows:   not attempted",
          "T2.2 depth of field: not attempted", "Nothing attempted yet"})
        EXPECT_NE(checked.output.find(line), std::string::npos) << line << "\n" << checked.output;
    for (const char* picture : {"bump-mapping", "bumpmap-test", "distributed"})
        EXPECT_TRUE(fs::exists(package().folder() / "pictures" / (std::string{picture} + ".png")));
}

TEST_F(PackageAlone, DoesWhatItsDocumentsSay) {
    putSolution("student_template/exercise");
    for (const char* document :
         {"student_template/README.md", "docs/handout.md", "docs/for-students.md"}) {
        const std::vector<tests::ShellBlock> blocks = tests::shellBlocks(document);
        std::ofstream{package().folder() / "commands.sh"} << tests::scriptOf(blocks);
        const tests::CommandResult ran = package().runAlone("bash commands.sh");
        EXPECT_EQ(ran.status, 0) << ran.output;
        std::cout << tests::skippedIn(blocks);
    }
}

TEST_F(PackageAlone, PassesTheModelAnswer) {
    putSolution("reference_solution/exercise");
    const tests::CommandResult checked = package().runAlone("./check");

    EXPECT_EQ(checked.status, 0) << checked.output;
    EXPECT_EQ(checked.output.find("not attempted"), std::string::npos) << checked.output;
    EXPECT_EQ(checked.output.find("NOT YET"), std::string::npos) << checked.output;
    for (const char* part : {"Hand in BumpySphere.cpp", "Hand in Renderer.cpp"})
        EXPECT_NE(checked.output.find(part), std::string::npos) << checked.output;
}

TEST_F(PackageAlone, SaysWhatIsLikelyWrong) {
    putSolution("student_template/exercise");
    put("BumpySphere.cpp",
        tests::readFile("grader/samples/notAwarded/bump-inverted-u/BumpySphere.cpp"));
    const tests::CommandResult checked = package().runAlone("./check --quick");

    EXPECT_EQ(checked.status, 1) << checked.output;
    for (const char* part :
         {"NOT YET", "expected:", "got:", "the bumps are inverted along u", "handout:"})
        EXPECT_NE(checked.output.find(part), std::string::npos) << part << "\n" << checked.output;
    EXPECT_EQ(checked.output.find("inverted along v"), std::string::npos) << checked.output;
}

TEST_F(PackageAlone, PutsTheFirstCauseOfACompileErrorOnTop) {
    putSolution("student_template/exercise");
    std::string text = tests::readFile("student_template/exercise/BumpySphere.cpp");
    const std::string end = "    // TASK T1 end";
    text.replace(text.find(end), end.size(), "    int columns = heightMap().widht()\n" + end);
    put("BumpySphere.cpp", text);
    const tests::CommandResult checked = package().runAlone("./check --quick");

    EXPECT_EQ(checked.status, 1) << checked.output;
    const std::string expected = "It does not compile. The first cause:\nexercise/BumpySphere.cpp:";
    EXPECT_EQ(checked.output.substr(0, expected.size()), expected) << checked.output;
    EXPECT_NE(checked.output.find("widht"), std::string::npos) << checked.output;
}

TEST_F(PackageAlone, SurvivesACrashOfOneTask) {
    putSolution("reference_solution/exercise");
    std::string text = tests::readFile("student_template/exercise/BumpySphere.cpp");
    const std::string end = "    // TASK T1 end";
    const std::string begin = "    unfinished(";
    text.replace(text.find(begin), text.find(end) - text.find(begin),
                 "    return *reinterpret_cast<const volatile double*>(8) > 0 ? position : "
                 "Vector3{};\n");
    put("BumpySphere.cpp", text);
    const tests::CommandResult checked = package().runAlone("./check --quick");

    EXPECT_EQ(checked.status, 1) << checked.output;
    EXPECT_NE(checked.output.find("bump mapping:  crashed"), std::string::npos) << checked.output;
    EXPECT_NE(checked.output.find("T2.2 depth of field: 11 of 11"), std::string::npos)
        << checked.output;
}

}  // namespace
}  // namespace ticker
