#ifndef TICKER_TASKS_DISTRIBUTED_FINDINGTEXT_H
#define TICKER_TASKS_DISTRIBUTED_FINDINGTEXT_H

#include <grader/result/FindingText.h>
#include <grader/result/SubmissionResult.h>

#include <span>
#include <string>
#include <vector>

namespace ticker::tasks {

/// A finding with the hint and the handout's section of its text.
/// @param seen  What was expected and what was seen: the message.
[[nodiscard]] Finding distributedFinding(const FindingText& text, Severity severity,
                                         std::string seen);

[[nodiscard]] bool hasFailure(const std::vector<Finding>& findings);

/// Puts findings into their order of rank and keeps the first failure: the names of the others
/// become its evidence, warnings and notes follow it.
/// @param order  The table of the task; what is not in it comes last.
[[nodiscard]] std::vector<Finding> mostImportantFirst(std::vector<Finding> findings,
                                                      std::span<const FindingText* const> order);

/// Passed, or failed where one of the findings fails.
/// @param needsReview  Counts where nothing fails.
[[nodiscard]] TaskJudgement judgementOf(std::vector<Finding> findings,
                                        std::span<const FindingText* const> order,
                                        bool needsReview = false);

/// The note that rays cannot be followed.
[[nodiscard]] Finding unseenRays(const FindingText& text, const std::string& what);

}  // namespace ticker::tasks

#endif
