#ifndef TICKER_TASKS_JUDGEDISTRIBUTED_H
#define TICKER_TASKS_JUDGEDISTRIBUTED_H

#include <grader/tasks/lens/JudgeLens.h>
#include <grader/tasks/shadows/JudgeShadows.h>

namespace ticker::tasks {

/// Which of the two tasks are attempted. A task that is not attempted is still the stub.
struct DistributedAttempt {
    bool softShadows = true;   ///< T2.1
    bool depthOfField = true;  ///< T2.2
};

struct DistributedJudgement {
    TaskJudgement softShadows{TaskState::notAttempted, {}, {}};
    TaskJudgement depthOfField{TaskState::notAttempted, {}, {}};
};

/// Both tasks of Renderer.cpp, for the lab and for tests.
[[nodiscard]] inline DistributedJudgement judgeDistributed(probe::Examinee& examinee,
                                                           const DistributedAttempt& attempt,
                                                           std::uint64_t seed) {
    DistributedJudgement judgement;
    if (attempt.softShadows) judgement.softShadows = judgeShadows(examinee, seed);
    if (attempt.depthOfField) judgement.depthOfField = judgeLens(examinee, seed);
    return judgement;
}

}  // namespace ticker::tasks

#endif
