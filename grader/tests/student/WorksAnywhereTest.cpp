// What a student's folder goes through: debug prints, copies, editors, other languages, git.
#include <grader/tests/student/PackageAlone.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

namespace ticker {
namespace {

namespace fs = std::filesystem;
using tests::PackageAlone;

/// The model answer of T1 with `statement` at its begin, and with its bumps inverted along u where
/// `isWrong`.
std::string bumpsWith(const std::string& statement, bool isWrong) {
    std::string text =
        tests::readFile(isWrong ? "grader/corpus/samples/notAwarded/bump-inverted-u/BumpySphere.cpp"
                                : "reference_solution/exercise/BumpySphere.cpp");
    const std::string begin = "// TASK T1 begin\n";
    text.insert(text.find(begin) + begin.size(), statement + "\n");
    return "#include <iostream>\n" + text;
}

TEST_F(PackageAlone, ShowsTheFailureBesideAHundredThousandDebugPrints) {
    putSolution("student_template/exercise");
    put("BumpySphere.cpp",
        bumpsWith("for (int i = 0; i < 40; ++i) std::cout << \"C:\\\\x [\\\\; \" << i << '\\n';\n"
                  "std::cerr << \"T1   bump mapping:   no line end [\";",
                  true));
    const tests::CommandResult checked = package().runAlone("timeout 100 ./check --quick");

    EXPECT_EQ(checked.status, 1) << checked.output.substr(0, 10'000);
    EXPECT_LT(checked.output.size(), 20'000U);
    EXPECT_LT(std::ranges::count(checked.output, '\n'), 100);
    for (const char* part : {"  C:\\x [\\; 0\n", "build/answers/BumpMapping.txt", "\nNOT YET: T1",
                             "the bumps are inverted along u", " public tests passed",
                             "Not yet: mend the first test above"})
        EXPECT_NE(checked.output.find(part), std::string::npos) << part << "\n" << checked.output;
    EXPECT_GT(fs::file_size(package().folder() / "build/answers/BumpMapping.txt"), 1'000'000U);
}

TEST_F(PackageAlone, CountsTheTestsOfASolutionThatPrintsNul) {
    putSolution("student_template/exercise");
    put("BumpySphere.cpp",
        bumpsWith("std::cout << \"a [\" << '\\0' << \"b;\" << std::endl;", false));
    const tests::CommandResult checked = package().runAlone("./check --quick");

    EXPECT_EQ(checked.status, 0) << checked.output.substr(0, 10'000);
    EXPECT_NE(checked.output.find("T1   bump mapping:   11 of 11"), std::string::npos)
        << checked.output.substr(0, 10'000);
}

// An instructor's task may have neither pictures nor public tests.
TEST_F(PackageAlone, GoesOnWithAnOptionThatHasNoPictures) {
    putSolution("student_template/exercise");
    const fs::path file = package().folder() / "check.json";
    const std::string before = tests::readFile(file.string());
    nlohmann::json description = nlohmann::json::parse(before);
    description["options"].push_back(
        {{"name", "3"}, {"file", "exercise/Toy.cpp"}, {"tasks", nlohmann::json::array({"T3"})}});
    std::ofstream{file} << description.dump(2);
    const tests::CommandResult checked = package().runAlone("./check");
    std::ofstream{file} << before;

    EXPECT_EQ(checked.status, 0) << checked.output;
    EXPECT_NE(checked.output.find("T3 no public tests"), std::string::npos) << checked.output;
}

TEST_F(PackageAlone, TellsByTheStatusOfViewThatTheCompilerIsMissing) {
    EXPECT_EQ(package()
                  .runAlone("cp -r /student /tmp/copy && cd /tmp/copy && rm -rf build && "
                            "CXX=/nowhere ./check --view")
                  .status,
              2);
}

TEST_F(PackageAlone, ShowsAFewDebugPrintsWhole) {
    putSolution("student_template/exercise");
    put("BumpySphere.cpp",
        bumpsWith("static const bool isSaid = (std::cout << \"one [line\\\\\" << std::endl, true);"
                  "static_cast<void>(isSaid);",
                  false));
    const tests::CommandResult checked = package().runAlone("./check --quick");

    EXPECT_EQ(checked.status, 0) << checked.output;
    for (const char* part :
         {"Your code printed this itself:\n  one [line\\\n", "T1   bump mapping:   11 of 11",
          "Option 1: hand in exercise/BumpySphere.cpp and screenshot.png"})
        EXPECT_NE(checked.output.find(part), std::string::npos) << part << "\n" << checked.output;
}

TEST_F(PackageAlone, BuildsItsOwnFilesInACopyWithTheOriginalsBuild) {
    putSolution("student_template/exercise");
    EXPECT_EQ(package().runAlone("./check --quick").status, 0);
    std::ofstream{package().folder() / "solved"}
        << tests::readFile("reference_solution/exercise/BumpySphere.cpp");
    const tests::CommandResult checked = package().runAlone(
        "cp -r /student /tmp/copy && cd /tmp/copy && cp solved exercise/BumpySphere.cpp && "
        "./check --quick && ./check --quick");
    fs::remove(package().folder() / "solved");

    EXPECT_EQ(checked.status, 0) << checked.output;
    const std::string again = "What is in build/ was made for another folder";
    for (const std::string& part : {again, std::string{"T1   bump mapping:   11 of 11"}})
        EXPECT_NE(checked.output.find(part), std::string::npos) << part << "\n" << checked.output;
    EXPECT_EQ(checked.output.find(again), checked.output.rfind(again)) << checked.output;
}

TEST_F(PackageAlone, ViewsTheCopyAndNotTheOriginal) {
    putSolution("student_template/exercise");
    EXPECT_EQ(package().runAlone("./check --quick").status, 0);
    // Without any such scene the viewer ends at once.
    const tests::CommandResult viewed = package().runAlone(
        "cp -r /student /tmp/copy && cd /tmp/copy && ./check --view none.xml; "
        "grep CMAKE_HOME_DIRECTORY build/release/CMakeCache.txt");

    EXPECT_NE(viewed.output.find("CMAKE_HOME_DIRECTORY:INTERNAL=/tmp/copy\n"), std::string::npos)
        << viewed.output;
}

TEST_F(PackageAlone, IgnoresWhatEditorsAndSystemsLeaveBesideTheFiles) {
    putSolution("student_template/exercise");
    fs::create_symlink("ann@laptop.1234:5", package().folder() / "exercise/.#Renderer.cpp");
    put("._BumpySphere.cpp", "attributes");
    const tests::CommandResult checked = package().runAlone("./check --quick");
    fs::remove(package().folder() / "exercise/.#Renderer.cpp");
    fs::remove(package().folder() / "exercise/._BumpySphere.cpp");

    EXPECT_EQ(checked.status, 0) << checked.output;
}

TEST_F(PackageAlone, AsksTheCompilerForEnglishAndKeepsTheLettersOfNames) {
    std::ofstream{package().folder() / "cmake-that-tells"}
        << "#!/bin/sh\necho \"<$LC_ALL|$LANGUAGE|$LC_MESSAGES|$LC_CTYPE>\"\n";
    const tests::CommandResult ran = package().runAlone(
        "mkdir /tmp/bin && cp cmake-that-tells /tmp/bin/cmake && chmod +x /tmp/bin/cmake && "
        "PATH=/tmp/bin:$PATH LC_ALL=de_DE.UTF-8 LANGUAGE=de ./check --quick");
    fs::remove(package().folder() / "cmake-that-tells");

    EXPECT_NE(ran.output.find("<||C|de_DE.UTF-8>"), std::string::npos) << ran.output;
}

TEST_F(PackageAlone, PutsDebugProgramsWhereF5LooksForThemWithVisualStudiosKindOfBuild) {
    putSolution("student_template/exercise");
    // Its generator makes several kinds in one folder, as this one does.
    const tests::CommandResult built = package().runAlone(
        "cmake --preset debug -G \"Ninja Multi-Config\" -B /tmp/several "
        ">/dev/null && "
        "cmake --build /tmp/several --config Debug --target build_bar >/dev/null && "
        "test -x build/debug/bin/build_bar");
    EXPECT_EQ(built.status, 0) << built.output;
    const nlohmann::json tasks =
        nlohmann::json::parse(tests::readFile("student_template/.vscode/tasks.json")).at("tasks");
    const std::string shell = "/windows/options/shell/executable";
    for (const nlohmann::json& task : tasks)
        EXPECT_TRUE(task.at("command").get<std::string>().find("&&") == std::string::npos ||
                    task.value(nlohmann::json::json_pointer{shell}, "") == "cmd.exe")
            << "PowerShell has no &&: " << task.dump();
}

TEST_F(PackageAlone, KeepsItsLineEndsAndItsBuildOutOfARepository) {
    EXPECT_EQ(tests::readFile("student_template/check").find('\r'), std::string::npos);
    EXPECT_NE(tests::readFile("student_template/.gitattributes").find("/check text eol=lf\n"),
              std::string::npos);
    EXPECT_EQ(tests::readFile("student_template/.gitignore"), "/build/\n/pictures/\n");
}

}  // namespace
}  // namespace ticker
