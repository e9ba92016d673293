#include <grader/report/platforms/PlatformFormats.h>

#include <nlohmann/json.hpp>

namespace ticker::report {
namespace {

using nlohmann::ordered_json;

// Autolab marks each entry of a stage as right or wrong if the entries are objects, and shows plain
// strings without marks.
constexpr const char* kMarked = "Tick";
constexpr const char* kUnmarked = "Not decided";

ordered_json stepOf(const StudentView& view, const TaskReport& task) {
    ordered_json step;
    step["passed"] = task.state == TaskState::passed;
    if (task.state != TaskState::passed || !task.findings.empty())
        step["hint"] = shortText(view, task);
    return step;
}

ordered_json feedbackOf(const StudentView& view) {
    ordered_json marked = ordered_json::object();
    ordered_json unmarked = ordered_json::object();
    for (const TaskReport& task : view.result().tasks) {
        if (!concernsStudent(task)) continue;
        if (isCertain(task))
            marked[taskName(task)] = stepOf(view, task);
        else
            unmarked[taskName(task)] = shortText(view, task);
    }
    ordered_json feedback;
    feedback["_presentation"] = "semantic";
    feedback["stages"] = ordered_json::array({kMarked});
    feedback[kMarked] = marked;
    if (!unmarked.empty()) {
        feedback["stages"].push_back(kUnmarked);
        feedback[kUnmarked] = unmarked;
    }
    return feedback;
}

}  // namespace

std::string autolabLines(const StudentView& view) {
    const SubmissionResult& result = view.result();
    ordered_json scores;
    scores["scores"][kMarked] = hasScore(result) ? ordered_json(result.score) : ordered_json();
    return wholeText(view) + "\n" + feedbackOf(view).dump() + "\n" + scores.dump() + "\n";
}

}  // namespace ticker::report
