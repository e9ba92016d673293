#include <grader/tests/student/PackageAlone.h>
#include <grader/tests/support/Files.h>
#include <grader/tests/support/ShellBlocks.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace ticker {
namespace {

namespace fs = std::filesystem;

using tests::PackageAlone;

TEST_F(PackageAlone, SaysThatNothingIsAttemptedAndRendersAtOnce) {
    putSolution("student_template/exercise");
    const tests::CommandResult checked = package().runAlone("./check");

    EXPECT_EQ(checked.status, 0) << checked.output;
    for (const char* line :
         {"The first time, everything is built", "Building: 50 %",
          "T1   bump mapping:   not attempted", "T2.1 soft shadows:   not attempted",
          "T2.2 depth of field: not attempted", "Nothing attempted yet"})
        EXPECT_NE(checked.output.find(line), std::string::npos) << line << "\n" << checked.output;
    for (const char* picture : {"bump-mapping", "bumpmap-test", "distributed"})
        EXPECT_TRUE(fs::exists(package().folder() / "pictures" / (std::string{picture} + ".png")));
}

TEST_F(PackageAlone, DrawsABarOnATerminal) {
    putSolution("student_template/exercise");
    // Compiled anew, it takes longer than the bar's first step.
    const tests::CommandResult checked = package().runAlone(
        "touch exercise/Renderer.cpp && CCACHE_DISABLE=1 script -qec \"./check --quick\" "
        "/dev/null");

    EXPECT_EQ(checked.status, 0) << checked.output;
    EXPECT_NE(checked.output.find("Building: [#"), std::string::npos) << checked.output;
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
    for (const char* part :
         {"One option is enough. Hand in exercise/BumpySphere.cpp and exercise/Renderer.cpp, or "
          "one of them,",
          "and ONE picture as screenshot.png"})
        EXPECT_NE(checked.output.find(part), std::string::npos) << checked.output;
    EXPECT_EQ(checked.output.find("The first time"), std::string::npos) << checked.output;
}

/// The commands that ./check suggests.
std::vector<std::string> commandsIn(const std::string& output) {
    std::vector<std::string> commands;
    std::istringstream lines{output};
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("  build/tick1star ")) commands.push_back(line.substr(2));
    return commands;
}

TEST_F(PackageAlone, NamesACommandForThePictureOfEachOption) {
    putSolution("reference_solution/exercise");
    const tests::CommandResult checked = package().runAlone("./check --quick");
    const std::vector<std::string> commands = commandsIn(checked.output);
    ASSERT_EQ(commands.size(), 2U) << checked.output;

    for (const std::string& command : commands) {
        // The grader refuses two pictures that differ: they replace each other.
        EXPECT_NE(command.find(" -o screenshot.png"), std::string::npos) << command;
        const tests::CommandResult ran = package().runAlone(command + " -r 64x48 --seed 1");
        EXPECT_EQ(ran.status, 0) << command << "\n" << ran.output;
        fs::rename(package().folder() / "screenshot.png",
                   package().folder() / (command == commands.front() ? "1.png" : "2.png"));
    }
    // Option 1's picture must be right for a student who solved only option 1.
    put("Renderer.cpp", tests::readFile("student_template/exercise/Renderer.cpp"));
    const tests::CommandResult alone = package().runAlone("./check --quick");
    const std::vector<std::string> command = commandsIn(alone.output);
    ASSERT_EQ(command.size(), 1U) << alone.output;
    EXPECT_NE(alone.output.find("Option 2 is not attempted; one option is enough."),
              std::string::npos)
        << alone.output;
    EXPECT_EQ(alone.output.find("T2."), std::string::npos) << alone.output;
    const tests::CommandResult drawn = package().runAlone(command.front() + " -r 64x48 --seed 1");
    EXPECT_EQ(drawn.output, "");
    EXPECT_EQ(package().runAlone("cmp screenshot.png 1.png").status, 0);
    EXPECT_NE(package().runAlone("cmp screenshot.png 2.png").status, 0);
}

TEST_F(PackageAlone, DebugsWithF5InVisualStudioCode) {
    putSolution("student_template/exercise");
    const nlohmann::json launch =
        nlohmann::json::parse(tests::readFile("student_template/.vscode/launch.json"))
            .at("configurations")
            .at(0);
    const nlohmann::json tasks =
        nlohmann::json::parse(tests::readFile("student_template/.vscode/tasks.json")).at("tasks");
    const auto task = std::ranges::find_if(tasks, [&](const nlohmann::json& one) {
        return one.at("label") == launch.at("preLaunchTask");
    });
    ASSERT_NE(task, tasks.end());
    const tests::CommandResult built = package().runAlone(task->at("command").get<std::string>());
    EXPECT_EQ(built.status, 0) << built.output;
    std::string program = launch.at("program");
    const std::string root = "${workspaceFolder}/";
    ASSERT_TRUE(program.starts_with(root)) << program;
    EXPECT_TRUE(fs::exists(package().folder() / program.substr(root.size()))) << program;
    // LeakSanitizer ends every run under a debugger.
    EXPECT_EQ(launch.at("environment").at(0).at("name"), "ASAN_OPTIONS");
    EXPECT_EQ(launch.at("environment").at(0).at("value"), "detect_leaks=0");
}

TEST(Devcontainer, ChoosesAGeneratorWhoseProgramItInstalls) {
    // What F5 runs names none, and CMake's own choice would be make.
    const std::string file = tests::readFile("student_template/.devcontainer/Dockerfile");
    EXPECT_NE(file.find("ENV CMAKE_GENERATOR=Ninja"), std::string::npos) << file;
    EXPECT_NE(file.find(" ninja-build "), std::string::npos) << file;
}

TEST_F(PackageAlone, TellsClangdWhereTheCompileCommandsAre) {
    putSolution("student_template/exercise");
    EXPECT_EQ(package().runAlone("./check --quick").status, 0);
    EXPECT_TRUE(fs::exists(package().folder() / "build/release/compile_commands.json"));
    EXPECT_NE(
        tests::readFile("student_template/.clangd").find("CompilationDatabase: build/release"),
        std::string::npos);
}

TEST_F(PackageAlone, SaysWhatIsLikelyWrong) {
    putSolution("student_template/exercise");
    put("BumpySphere.cpp",
        tests::readFile("grader/corpus/samples/notAwarded/bump-inverted-u/BumpySphere.cpp"));
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
    EXPECT_NE(
        checked.output.find("It does not compile. The first cause:\nexercise/BumpySphere.cpp:"),
        std::string::npos)
        << checked.output;
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
    for (const char* part :
         {"NOT YET: T1   Every point of a map of any size has a normal", "your code crashed",
          "T1   bump mapping:   crashed", "public_tests \"--gtest_filter=BumpMapping.*\""})
        EXPECT_NE(checked.output.find(part), std::string::npos) << part << "\n" << checked.output;
    EXPECT_NE(checked.output.find("T2.2 depth of field: 11 of 11"), std::string::npos)
        << checked.output;
}

}  // namespace
}  // namespace ticker
