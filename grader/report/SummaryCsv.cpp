#include <grader/report/Escape.h>
#include <grader/report/ReportWords.h>
#include <grader/report/SummaryCsv.h>
#include <grader/result/Names.h>
#include <grader/result/Tally.h>

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>

namespace ticker::report {
namespace {

std::string stateOf(const SubmissionResult& result, const std::string& id) {
    for (const TaskReport& task : result.tasks)
        if (task.id == id) return std::string{kindOf(task)};
    return "";
}

std::string findingsOf(const SubmissionResult& result) {
    return fmt::format("{}", fmt::join(findingIds(result), " "));
}

std::string decisionOf(const SubmissionResult& result, const std::vector<Decision>& decisions) {
    const auto decision = std::ranges::find(decisions, result.submission, &Decision::submission);
    const bool isDecided = decision != decisions.end() && decision->ruling != Ruling::undecided;
    const bool isTold = isDecided || (decision != decisions.end() && !decision->comment.empty());
    if (!isTold) return ",,,";
    return fmt::format("{},{},{},{}",
                       isDecided ? nameIn(kRulingNames, decision->ruling) : std::string_view{},
                       escapeCsv(decision->who), decision->when, escapeCsv(decision->comment));
}

}  // namespace

std::string summaryCsv(const std::vector<SubmissionResult>& results,
                       const std::vector<Decision>& decisions, const Exercise& exercise) {
    std::string text = "submission,verdict,score,option";
    for (const std::string& task : exercise.reported())
        text += fmt::format(",{}", task);
    text += ",findings,ruling,decidedBy,decidedAt,comment\r\n";
    for (const SubmissionResult& result : results) {
        text += fmt::format("{},{},{:g},{}", escapeCsv(result.submission), toString(result.verdict),
                            result.score, escapeCsv(result.option));
        for (const std::string& task : exercise.reported())
            text += "," + stateOf(result, task);
        text += "," + escapeCsv(findingsOf(result)) + "," + decisionOf(result, decisions) + "\r\n";
    }
    return text;
}

std::string summaryCsv(const std::vector<SubmissionResult>& results,
                       const std::vector<Decision>& decisions) {
    return summaryCsv(results, decisions, exerciseOf(results));
}

}  // namespace ticker::report
