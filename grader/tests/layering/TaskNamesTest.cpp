#include <grader/tests/layering/Includes.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

// Tasks, their files and their scenes are data, which code takes from the exercise.
namespace ticker {
namespace {

namespace fs = std::filesystem;
using namespace tests;

const fs::path kProject{TICKER_SOURCE_DIR};

std::set<std::string> filesThatNameATask() {
    const std::regex name{
        R"RE("T1"|"T2"|"T2\.[12]"|BumpySphere\.cpp|Renderer\.cpp|"bump-mapping"|"distributed"|)RE"
        R"RE(SourceFile::|Part::|isForT1)RE"};
    const std::set<std::string> exempt{"tasks", "exercises", "corpus", "tests"};
    std::set<std::string> found;
    for (const fs::path& file : sources()) {
        const std::string path = fs::relative(file, kProject).string();
        const std::string folder = path.substr(0, path.find('/', 7));
        if (path.starts_with("student_template/") || path.starts_with("reference_solution/"))
            continue;
        if (path.starts_with("grader/") && exempt.contains(folder.substr(7))) continue;
        for (const std::string& line : linesOf(file))
            if (std::regex_search(line, name)) found.insert(path);
    }
    return found;
}

TEST(TaskNames, StandInFewFilesOutsideTheTasks) {
    const std::set<std::string> found = filesThatNameATask();
    std::string list;
    for (const std::string& file : found)
        list += "\n  " + file;
    EXPECT_LE(found.size(), 10U) << list;
}

TEST(TaskNames, StandInNoneThatASubmissionPasses) {
    for (const std::string& file : filesThatNameATask())
        for (const char* folder : {"intake", "build", "pipeline", "rubric", "report", "session",
                                   "store", "package", "exercise", "result"})
            EXPECT_FALSE(file.starts_with("grader/" + std::string{folder} + "/")) << file;
}

}  // namespace
}  // namespace ticker
