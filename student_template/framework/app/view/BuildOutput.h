#ifndef RAYTRACER_APP_VIEW_BUILDOUTPUT_H
#define RAYTRACER_APP_VIEW_BUILDOUTPUT_H

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace raytracer::view {

/// The first error of a compiler or linker.
struct FirstError {
    std::string file;  ///< as the compiler writes it; empty where the linker complains
    int line = 0;
    std::string message;
};

/// Reads what GCC, Clang or Microsoft's compiler wrote. Empty where nothing in it is an error.
[[nodiscard]] std::optional<FirstError> firstErrorIn(std::string_view output);

/// What the public tests say, for a person who works on some of the tasks.
struct TestOutcome {
    bool hasFailed = false;
    std::string title;    ///< of the first test that fails: "T1   Normals have unit length"
    std::string text;     ///< what it asked, expected and got
    std::string summary;  ///< a line for each of the tasks
};

/// Reads the output of the public tests piece by piece. The student's code may print between its
/// lines, any amount and without line ends.
class TestReader {
public:
    /// @param tasks  Tags of the tasks; empty: all.
    explicit TestReader(std::set<std::string> tasks) : tasks_(std::move(tasks)) {}

    void add(std::string_view bytes);
    /// A task's tests ended before all were asked.
    /// @param how  Words that follow the task: "ended too early". @param output  What they wrote
    ///             last.
    void addEarlyEnd(const std::string& task, std::string_view how, std::string_view output);
    [[nodiscard]] const TestOutcome& outcome() const { return outcome_; }

private:
    void readLine();

    std::set<std::string> tasks_;
    TestOutcome outcome_;
    std::string line_;       // so far
    bool isInside_ = false;  // the first failing test
};

/// The tags that a file of the exercise has marks of: "// TASK T1 begin".
[[nodiscard]] std::set<std::string> tasksIn(std::string_view source);

}  // namespace raytracer::view

#endif
