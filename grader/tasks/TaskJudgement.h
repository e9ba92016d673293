#ifndef TICKER_TASKS_TASKJUDGEMENT_H
#define TICKER_TASKS_TASKJUDGEMENT_H

#include <grader/result/SubmissionResult.h>

#include <optional>
#include <string>
#include <vector>

namespace ticker::tasks {

/// What the decision says about one task. `state` is passed, failed, blocked (crashed, timed out)
/// or notGraded; notAttempted and build failures are known before. `findings` begins
/// with the one that is reported first (in the order of docs/findings.md); a failed task has at
/// least one finding of severity fail.
struct TaskJudgement {
    TaskState state = TaskState::notGraded;
    std::string reason;
    std::vector<Finding> findings;
    bool needsReview = false;  ///< a person should look: the reason is among the findings
    std::vector<ScatterPlot> plots = {};  ///< what was seen, where no finding shows it
    std::vector<Raster> rasters = {};     ///< likewise
    /// T2.2: half-width / dofAmount of the accepted aperture that the answers show.
    std::optional<double> apertureFactor = {};
};

}  // namespace ticker::tasks

#endif
