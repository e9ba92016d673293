#ifndef TICKER_CLI_BATCH_H
#define TICKER_CLI_BATCH_H

#include <grader/intake/Intake.h>
#include <grader/pipeline/Grade.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

namespace ticker::cli {

/// Grades submissions on several workers. Each result goes to `take`, one at a time, as soon as it
/// is there. One bad submission never stops the rest: what cannot be graded for reasons that are
/// ours is tried once more and then notGraded. Once `stop` is true no further one is begun.
void gradeAll(const std::vector<intake::Located>& submissions, const pipeline::Grader& grader,
              std::uint64_t seed, int workers, const std::atomic<bool>& stop,
              const std::function<void(const intake::Located&, const SubmissionResult&)>& take);

}  // namespace ticker::cli

#endif
