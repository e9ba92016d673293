#ifndef TICKER_REPAIR_TASKLOOKUP_H
#define TICKER_REPAIR_TASKLOOKUP_H

#include <grader/pipeline/Grade.h>
#include <grader/result/SubmissionResult.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ticker::repair {

using pipeline::codeOf;

[[nodiscard]] inline bool passes(const TaskJudgement& judgement) {
    return judgement.state == TaskState::passed && !judgement.needsReview;
}

/// Whether it holds a warning that was not there before, such as a quantity of another setting in
/// place of the right one.
[[nodiscard]] inline bool addsWarning(const TaskJudgement& judgement, const TaskJudgement& before) {
    return std::ranges::any_of(judgement.findings, [&](const Finding& finding) {
        return finding.severity == Severity::warn &&
               std::ranges::find(before.findings, finding.id, &Finding::id) ==
                   before.findings.end();
    });
}

/// The first failing finding; empty: none.
[[nodiscard]] inline std::string firstFailure(const TaskJudgement& judgement) {
    for (const Finding& finding : judgement.findings)
        if (finding.severity == Severity::fail) return finding.id;
    return {};
}

/// All failing findings, sorted.
[[nodiscard]] inline std::vector<std::string> failuresOf(const TaskJudgement& judgement) {
    std::vector<std::string> ids;
    for (const Finding& finding : judgement.findings)
        if (finding.severity == Severity::fail) ids.push_back(finding.id);
    std::ranges::sort(ids);
    return ids;
}

}  // namespace ticker::repair

#endif
