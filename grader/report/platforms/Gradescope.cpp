#include <grader/report/platforms/PlatformFormats.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace ticker::report {
namespace {

using nlohmann::ordered_json;

ordered_json testOf(const StudentView& view, const TaskReport& task, int number) {
    ordered_json test;
    if (isCertain(task)) test["status"] = task.state == TaskState::passed ? "passed" : "failed";
    test["name"] = taskName(task);
    test["name_format"] = "text";
    test["number"] = std::to_string(number);
    test["output"] = taskText(view, task);
    test["output_format"] = "text";
    test["visibility"] = "visible";
    return test;
}

/// A test that students see later; Gradescope hides the score until then.
ordered_json laterTest(std::size_t number) {
    ordered_json test;
    test["name"] = "Tick";
    test["name_format"] = "text";
    test["number"] = std::to_string(number);
    test["output"] = "A person has looked at this.";
    test["output_format"] = "text";
    test["visibility"] = "after_published";
    return test;
}

}  // namespace

std::optional<std::string> gradescopeJson(const StudentView& view) {
    const SubmissionResult& result = view.result();
    if (result.verdict == Verdict::notGraded) return std::nullopt;
    ordered_json tests = ordered_json::array();
    int number = 0;
    for (const TaskReport& task : result.tasks)
        if (++number; concernsStudent(task)) tests.push_back(testOf(view, task, number));
    if (!hasScore(result)) tests.push_back(laterTest(result.tasks.size() + 1));
    ordered_json json;
    json["score"] = result.score;
    json["execution_time"] = std::ceil(result.timing.totalMs / 1000.0);
    json["output"] = verdictText(view);
    json["output_format"] = "text";
    json["test_output_format"] = "text";
    json["test_name_format"] = "text";
    json["visibility"] = "visible";
    json["stdout_visibility"] = "hidden";
    json["tests"] = tests;
    return json.dump(2) + "\n";
}

}  // namespace ticker::report
