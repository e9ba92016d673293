#ifndef TICKER_CLI_BATCH_H
#define TICKER_CLI_BATCH_H

#include <grader/intake/Intake.h>
#include <grader/pipeline/Grade.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace ticker::cli {

/// What a batch asks its caller, and tells him.
struct BatchHooks {
    /// The result that the submission has already and that still holds; empty: grade it. May be
    /// called by several threads at once; may be null.
    std::function<std::optional<SubmissionResult>(const intake::Located&, const Inputs&)> known;
    /// A fresh result, to be written. May be called by several threads at once; may be null.
    std::function<void(const SubmissionResult&)> write;
    /// Each result, one at a time, as soon as it is there.
    std::function<void(const intake::Located&, const SubmissionResult&, bool isKept)> take;
};

/// Grades submissions on several workers. One bad submission never stops the rest: what cannot be
/// graded for reasons that are ours is tried once more and then notGraded. Once `stop` is true no
/// further one is begun. What a hook throws ends the batch.
void gradeAll(const std::vector<intake::Located>& submissions, const pipeline::Grader& grader,
              std::uint64_t seed, int workers, const std::atomic<bool>& stop,
              const BatchHooks& hooks);

}  // namespace ticker::cli

#endif
