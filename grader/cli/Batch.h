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

/// Callbacks of a batch.
struct BatchHooks {
    /// Returns the submission's existing result if it is still valid; empty: grade it. Several
    /// threads may call it at once; may be null.
    std::function<std::optional<SubmissionResult>(const intake::Located&, const Inputs&)> known;
    /// May add to a fresh result before it is written; throws nothing. Several threads may call it
    /// at once; may be null.
    std::function<void(const intake::Submission&, SubmissionResult&)> complete = {};
    /// Writes a fresh result. Several threads may call it at once; may be null.
    std::function<void(const SubmissionResult&)> write;
    /// Receives each result when it is ready; never called in parallel.
    std::function<void(const intake::Located&, const SubmissionResult&, bool isKept)> take;
};

/// Grades submissions on several workers. A bad submission never stops the others: if grading fails
/// because of the grader or its system, it is tried once more, and then the result is notGraded.
/// The same applies to an exception of `known`; one of `write` or `take` ends the batch. Once
/// `stop` is true, no further submission is started.
void gradeAll(const std::vector<intake::Located>& submissions, const pipeline::Grader& grader,
              std::uint64_t seed, int workers, const std::atomic<bool>& stop,
              const BatchHooks& hooks);

}  // namespace ticker::cli

#endif
