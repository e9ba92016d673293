#ifndef TICKER_CLI_EXPLAINED_H
#define TICKER_CLI_EXPLAINED_H

#include <grader/intake/Submission.h>
#include <grader/pipeline/Grade.h>
#include <grader/result/SubmissionResult.h>

namespace ticker::cli {

/// True if a task failed in a way that edits may mend, and edits were not looked for yet.
[[nodiscard]] bool wantsRepairs(const SubmissionResult& result);

/// Looks for edits that mend the failed tasks, and puts the proven ones into the result; nothing
/// else of it changes. An error becomes a notice. Does nothing if no task failed.
void addRepairs(const intake::Submission& submission, const pipeline::Grader& grader,
                SubmissionResult& result);

}  // namespace ticker::cli

#endif
