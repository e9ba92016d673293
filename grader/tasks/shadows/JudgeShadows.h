#ifndef TICKER_TASKS_SHADOWS_JUDGESHADOWS_H
#define TICKER_TASKS_SHADOWS_JUDGESHADOWS_H

#include <grader/exercise/Judge.h>
#include <grader/probe/Examinee.h>
#include <grader/result/SubmissionResult.h>

#include <cstdint>

namespace ticker::tasks {

/// Judges task T2.1 by asking the submission for illuminated points and tiny renders.
///
/// @param seed  Source of every hidden question; equal seeds give equal findings for code that uses
///              the kit's generator.
[[nodiscard]] TaskJudgement judgeShadows(probe::Examinee& examinee, std::uint64_t seed);

/// Judges as `judgeShadows` does, and keeps what is expected in the penumbra for the next
/// submission under the same seed.
[[nodiscard]] Judge judgeShadowsOfMany();

}  // namespace ticker::tasks

#endif
