#include <grader/exercise/Exercise.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace ticker {
namespace {

const std::string kRoot = TICKER_SOURCE_DIR;

std::string readFile(const std::string& path) {
    std::ifstream file{path, std::ios::binary};
    EXPECT_TRUE(file) << path;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A solution's file: the text outside the marks of its tasks, and the tasks that are marked.
struct Marked {
    std::string outside;
    std::vector<std::string> tasks;
};

Marked readMarked(const std::string& path) {
    static const std::regex kMark{"// TASK ([^ ]+) (begin|end)$"};
    std::istringstream lines{readFile(path)};
    Marked marked;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        std::smatch mark;
        const bool isMark = std::regex_search(line, mark, kMark);
        const bool begins = isMark && mark[2] == "begin";
        EXPECT_FALSE(begins && inside) << path << ": " << line;
        if (isMark && !begins) inside = false;
        if (!inside) marked.outside += line + '\n';
        if (!begins) continue;
        inside = true;
        marked.tasks.push_back(mark[1]);
    }
    EXPECT_FALSE(inside) << path;
    std::ranges::sort(marked.tasks);
    return marked;
}

std::vector<std::string> tasksIn(const Exercise& exercise, const std::string& file) {
    std::vector<std::string> tasks;
    for (const TaskEntry& task : exercise.tasks)
        if (task.file == file) tasks.push_back(task.id);
    std::ranges::sort(tasks);
    return tasks;
}

TEST(ReferenceSolution, EqualsTheTemplateOutsideTheTaskMarks) {
    for (const Exercise& exercise : knownExercises())
        for (const std::string& file : exercise.files()) {
            const std::string stubPath = kRoot + "/" + exercise.stubs + "/" + file;
            const Marked stub = readMarked(stubPath);
            const Marked reference = readMarked(kRoot + "/" + exercise.reference + "/" + file);
            EXPECT_EQ(reference.outside, stub.outside) << stubPath;
            EXPECT_EQ(stub.tasks, tasksIn(exercise, file)) << stubPath;
            EXPECT_EQ(reference.tasks, stub.tasks) << stubPath;
        }
}

TEST(ReferenceSolution, HasNoStubLeftAndTheTemplateHasEachOnce) {
    for (const Exercise& exercise : knownExercises())
        for (const TaskEntry& task : exercise.tasks) {
            const std::string stub = readFile(kRoot + "/" + exercise.stubs + "/" + task.file);
            const std::string call = "unfinished(\"" + task.id + "\"";
            const std::size_t found = stub.find(call);
            EXPECT_NE(found, std::string::npos) << task.file << " has no " << call;
            EXPECT_EQ(stub.find(call, found + 1), std::string::npos) << call;
            const std::string solved = readFile(kRoot + "/" + exercise.reference + "/" + task.file);
            EXPECT_EQ(solved.find("unfinished("), std::string::npos) << task.file;
        }
}

}  // namespace
}  // namespace ticker
