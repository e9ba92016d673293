#include <grader/report/PlatformFormats.h>

#include <nlohmann/json.hpp>

#include <cctype>

namespace ticker::report {
namespace {

using nlohmann::ordered_json;

/// Autolab puts quotes around every word before a colon, also inside strings: a blank between the
/// two keeps it from that.
std::string withoutKeys(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == ':' && !safe.empty() && std::isalnum(static_cast<unsigned char>(safe.back())) != 0)
            safe += ' ';
        safe += c;
    }
    return safe;
}

ordered_json stepOf(const StudentView& view, const TaskReport& task) {
    ordered_json step;
    step["passed"] = task.state == TaskState::passed;
    if (task.state != TaskState::passed || !task.findings.empty())
        step["hint"] = withoutKeys(taskText(view, task));
    return step;
}

}  // namespace

std::optional<std::string> autolabLines(const StudentView& view) {
    const SubmissionResult& result = view.result();
    if (result.verdict == Verdict::notGraded) return std::nullopt;
    ordered_json feedback;
    feedback["_presentation"] = "semantic";
    feedback["stages"] = {"Tick"};
    feedback["Tick"] = ordered_json::object();
    for (const TaskReport& task : result.tasks)
        if (concernsStudent(task)) feedback["Tick"][taskName(task)] = stepOf(view, task);
    ordered_json scores;
    scores["scores"]["Tick"] = result.score;
    return feedback.dump() + "\n" + scores.dump() + "\n";
}

}  // namespace ticker::report
