#ifndef TICKER_TASKS_LENS_JUDGELENS_H
#define TICKER_TASKS_LENS_JUDGELENS_H

#include <grader/exercise/Judge.h>
#include <grader/probe/Examinee.h>
#include <grader/result/SubmissionResult.h>

#include <cstdint>

namespace ticker::tasks {

/// Judges task T2.2 by asking the submission for small renders.
///
/// @param seed  Source of every hidden question; equal seeds give equal findings for code that uses
///              the kit's generator.
[[nodiscard]] TaskJudgement judgeLens(probe::Examinee& examinee, std::uint64_t seed);

/// Judges as `judgeLens` does, and keeps the oracle's pictures for the next submission under the
/// same seed.
[[nodiscard]] Judge judgeLensOfMany();

}  // namespace ticker::tasks

#endif
