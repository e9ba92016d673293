#ifndef TICKER_TASKS_BUMP_WORDS_BUMPWORDS_H
#define TICKER_TASKS_BUMP_WORDS_BUMPWORDS_H

#include <grader/result/Finding.h>
#include <grader/tasks/bump/Examination.h>
#include <grader/tasks/bump/words/Diagnosis.h>

#include <optional>
#include <vector>

namespace ticker::tasks::bump {

/// The finding that a student reads: message, hint, section and evidence.
/// @param diagnosis  Of the examination, with at least one fault. The first is described, the
///                   others are named in the evidence.
[[nodiscard]] Finding describe(const Diagnosis& diagnosis, const Examination& examination,
                               const std::optional<Hints>& hints);

/// Findings that are harmless but should be known: mirrored text, trouble at poles.
[[nodiscard]] std::vector<Finding> sideNotes(const Examination& examination);

}  // namespace ticker::tasks::bump

#endif
