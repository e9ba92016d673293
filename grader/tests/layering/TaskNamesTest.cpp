#include <grader/tests/layering/Includes.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

// Tasks, their files and their scenes are data, which code takes from the exercise.
namespace ticker {
namespace {

namespace fs = std::filesystem;
using namespace tests;

const fs::path kProject{TICKER_SOURCE_DIR};

/// Code, scripts and data, without prose.
bool isText(const fs::path& file) {
    static const std::set<std::string> kEndings{"",      ".cpp",  ".h",   ".in",    ".txt",
                                                ".json", ".html", ".yml", ".cmake", ".sh",
                                                ".mjs",  ".js",   ".tpl", ".sbatch"};
    return kEndings.contains(file.extension().string());
}

std::vector<fs::path> filesOutsideTheTasks() {
    std::vector<fs::path> files{kProject / "tick", kProject / "CMakeLists.txt"};
    const std::set<std::string> exempt{"tasks", "exercises", "corpus", "tests", "record"};
    for (const char* top : {"grader", "tools", "cmake"})
        for (fs::recursive_directory_iterator at{kProject / top}, end; at != end; ++at)
            if (at->is_directory() && exempt.contains(at->path().filename().string()))
                at.disable_recursion_pending();
            else if (at->is_regular_file() && isText(at->path()))
                files.push_back(at->path());
    return files;
}

std::set<std::string> filesThatNameATask() {
    const std::regex name{R"RE(\bT1\b|"T2"|\bT2\.[12]\b|BumpySphere\.cpp|Renderer\.cpp|)RE"
                          R"RE(\bbump-mapping\b"|"distributed"|/distributed\.xml)RE"};
    std::set<std::string> found;
    for (const fs::path& file : filesOutsideTheTasks())
        for (const std::string& line : linesOf(file))
            if (std::regex_search(line, name)) found.insert(fs::relative(file, kProject).string());
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
            EXPECT_FALSE(file.starts_with("grader/" + std::string{folder} + "/") &&
                         !file.ends_with(".json"))
                << file;
}

}  // namespace
}  // namespace ticker
