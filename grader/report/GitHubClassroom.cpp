#include <grader/report/PlatformFormats.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace ticker::report {
namespace {

const char* statusOf(const SubmissionResult& result) {
    if (result.verdict == Verdict::notGraded) return "error";
    return result.verdict == Verdict::awarded ? "pass" : "fail";
}

}  // namespace

std::string classroomJson(const StudentView& view) {
    const SubmissionResult& result = view.result();
    nlohmann::ordered_json test;
    test["name"] = "Tick";
    test["status"] = statusOf(result);
    test["score"] = result.score;
    test["message"] = wholeText(view);
    test["test_code"] = "";
    test["filename"] = "";
    test["line_no"] = 0;
    test["duration"] = std::round(result.timing.totalMs);
    nlohmann::ordered_json json;
    json["version"] = 1;
    json["status"] = statusOf(result);
    json["max_score"] = result.maxScore;
    json["tests"] = nlohmann::ordered_json::array({test});
    return json.dump(2) + "\n";
}

}  // namespace ticker::report
