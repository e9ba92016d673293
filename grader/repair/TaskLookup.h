#ifndef TICKER_REPAIR_TASKLOOKUP_H
#define TICKER_REPAIR_TASKLOOKUP_H

#include <grader/pipeline/Grade.h>
#include <grader/result/SubmissionResult.h>

#include <algorithm>
#include <string>

namespace ticker::repair {

/// The code of a task that the exercise has.
[[nodiscard]] inline const Task& codeOf(const pipeline::Grader& grader, const std::string& id) {
    return *std::ranges::find(grader.tasks, id, &Task::id);
}

[[nodiscard]] inline bool passes(const TaskJudgement& judgement) {
    return judgement.state == TaskState::passed && !judgement.needsReview;
}

/// The first failing finding; empty: none.
[[nodiscard]] inline std::string firstFailure(const TaskJudgement& judgement) {
    for (const Finding& finding : judgement.findings)
        if (finding.severity == Severity::fail) return finding.id;
    return {};
}

}  // namespace ticker::repair

#endif
