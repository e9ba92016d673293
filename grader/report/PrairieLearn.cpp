#include <grader/report/PlatformFormats.h>

#include <nlohmann/json.hpp>

namespace ticker::report {
namespace {

using nlohmann::ordered_json;

/// Points only colour the line; the score is the rubric's. PrairieLearn shows a test without
/// possible points as neither right nor wrong.
ordered_json testOf(const StudentView& view, const TaskReport& task) {
    const bool isOpen = task.needsReview || task.state == TaskState::notGraded ||
                        task.state == TaskState::notAttempted;
    ordered_json test;
    test["name"] = taskName(task);
    test["points"] = !isOpen && task.state == TaskState::passed ? 1 : 0;
    test["max_points"] = isOpen ? 0 : 1;
    test["output"] = taskText(view, task);
    return test;
}

}  // namespace

std::string prairieLearnJson(const StudentView& view) {
    const SubmissionResult& result = view.result();
    ordered_json json;
    json["gradable"] = result.verdict != Verdict::notGraded;
    json["message"] = verdictText(view);
    if (result.verdict != Verdict::notGraded) {
        json["score"] = result.maxScore > 0.0 ? result.score / result.maxScore : 0.0;
        ordered_json tests = ordered_json::array();
        for (const TaskReport& task : result.tasks)
            if (concernsStudent(task)) tests.push_back(testOf(view, task));
        json["tests"] = tests;
    }
    return json.dump(2) + "\n";
}

}  // namespace ticker::report
