#include <grader/result/Tally.h>

#include <algorithm>

namespace ticker {

std::vector<std::string> findingIds(const SubmissionResult& result) {
    std::vector<std::string> ids;
    for (const TaskReport& task : result.tasks)
        for (const Finding& finding : task.findings)
            if (finding.severity != Severity::note &&
                std::ranges::find(ids, finding.id) == ids.end())
                ids.push_back(finding.id);
    return ids;
}

Tally tallyOf(const std::vector<SubmissionResult>& results) {
    Tally tally;
    std::map<std::string, int> findings;
    for (const SubmissionResult& result : results) {
        ++tally.verdicts[result.verdict];
        for (const std::string& id : findingIds(result))
            ++findings[id];
        for (const TaskReport& task : result.tasks) {
            if (task.id == "screenshot" || task.state == TaskState::notAttempted) continue;
            ++tally.tasks[task.id].tried;
            if (task.state == TaskState::passed) ++tally.tasks[task.id].passed;
        }
    }
    tally.findings.assign(findings.begin(), findings.end());
    std::stable_sort(tally.findings.begin(), tally.findings.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    return tally;
}

}  // namespace ticker
