#include <grader/report/platforms/PlatformFormats.h>

#include <grader/report/ReportWords.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace ticker::report {
namespace {

using nlohmann::ordered_json;

/// PrairieLearn shows the sum of all tests' points beside the score: therefore one test has them
/// all. It marks a test without possible points as neither right nor wrong.
ordered_json test(const std::string& name, double points, double maxPoints,
                  const std::string& output) {
    return {{"name", name}, {"points", points}, {"max_points", maxPoints}, {"output", output}};
}

std::string nameWithState(const TaskReport& task) {
    return fmt::format("{}: {}", taskName(task),
                       task.needsReview ? wordsFor(Verdict::needsReview) : wordsFor(task));
}

}  // namespace

std::string prairieLearnJson(const StudentView& view) {
    const SubmissionResult& result = view.result();
    ordered_json json;
    json["gradable"] = hasScore(result);
    json["message"] = verdictText(view);
    ordered_json tests = ordered_json::array();
    if (hasScore(result)) {
        const double share = result.maxScore > 0.0 ? result.score / result.maxScore : 0.0;
        json["score"] = share;
        tests.push_back(test("Tick", share, 1.0, verdictText(view)));
    }
    for (const TaskReport& task : result.tasks)
        if (concernsStudent(task))
            tests.push_back(test(nameWithState(task), 0.0, 0.0, taskText(view, task)));
    json["tests"] = tests;
    return json.dump(2) + "\n";
}

}  // namespace ticker::report
