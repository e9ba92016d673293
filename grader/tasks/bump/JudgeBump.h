#ifndef TICKER_TASKS_BUMP_JUDGEBUMP_H
#define TICKER_TASKS_BUMP_JUDGEBUMP_H

#include <grader/probe/Examinee.h>
#include <grader/result/SubmissionResult.h>

#include <cstdint>

namespace ticker::tasks {

/// Judges task T1 by asking the submission for normals.
///
/// @param seed  Source of the hidden questions; equal seeds give equal findings.
/// @return      Findings of task T1 (bump.*, run.*), the most important first.
[[nodiscard]] TaskJudgement judgeBump(probe::Examinee& examinee, std::uint64_t seed);

}  // namespace ticker::tasks

#endif
