#ifndef TICKER_TASKS_DISTRIBUTED_JUDGEDISTRIBUTED_H
#define TICKER_TASKS_DISTRIBUTED_JUDGEDISTRIBUTED_H

#include <grader/tasks/TaskJudgement.h>
#include <grader/probe/Examinee.h>

#include <cstdint>
#include <optional>

namespace ticker::tasks {

/// Which of the two tasks the submission attempted; the other one is still the stub.
struct DistributedAttempt {
    bool softShadows = true;   ///< T2.1
    bool depthOfField = true;  ///< T2.2
};

struct DistributedJudgement {
    TaskJudgement softShadows;   ///< T2.1: shadow.*, run.*, settings.*
    TaskJudgement depthOfField;  ///< T2.2: dof.*, run.*, settings.*
    /// Half-width / dofAmount of the accepted aperture that the answers show; empty where none
    /// does.
    std::optional<double> apertureFactor;
};

/// Judges tasks T2.1 and T2.2 by asking the submission for illuminated points and small renders.
///
/// @param seed  Every hidden question is drawn from it; equal seeds give equal findings for code
///              that uses the kit's generator.
[[nodiscard]] DistributedJudgement judgeDistributed(probe::Examinee& examinee,
                                                    const DistributedAttempt& attempt,
                                                    std::uint64_t seed);

}  // namespace ticker::tasks

#endif
