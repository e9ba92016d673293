#include <grader/report/platforms/PlatformFormats.h>

#include <grader/report/Escape.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace ticker::report {
namespace {

const char* statusOf(const SubmissionResult& result) {
    if (!hasScore(result)) return "error";
    return result.verdict == Verdict::awarded ? "pass" : "fail";
}

}  // namespace

std::string classroomJson(const StudentView& view) {
    const SubmissionResult& result = view.result();
    nlohmann::ordered_json test;
    test["name"] = "Tick";
    test["status"] = statusOf(result);
    test["score"] = result.score;
    // The reporter prints the message of an error, and GitHub interprets printed lines as commands:
    // the message must not contain text from a student.
    test["message"] = hasScore(result) ? wholeText(view) : verdictText(view);
    test["test_code"] = "";
    test["filename"] = "";
    test["line_no"] = 0;
    test["duration"] = std::round(result.timing.totalMs);
    nlohmann::ordered_json json;
    json["version"] = 1;
    json["status"] = statusOf(result);
    // Without a maximum the reporter sends no points.
    json["max_score"] = hasScore(result) ? result.maxScore : 0.0;
    json["tests"] = nlohmann::ordered_json::array({test});
    return json.dump(2) + "\n";
}

std::string classroomSummary(const StudentView& view) {
    return fmt::format("<pre>\n{}\n</pre>\n", escapeHtml(wholeText(view)));
}

}  // namespace ticker::report
