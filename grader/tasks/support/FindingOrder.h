#ifndef TICKER_TASKS_SUPPORT_FINDINGORDER_H
#define TICKER_TASKS_SUPPORT_FINDINGORDER_H

#include <grader/result/FindingText.h>
#include <grader/result/SubmissionResult.h>

#include <span>
#include <string>
#include <vector>

namespace ticker::tasks {

/// A finding with the id, the hint and the section of `text`.
/// @param seen  What was expected and what was observed: the message.
[[nodiscard]] Finding distributedFinding(const FindingText& text, Severity severity,
                                         std::string seen);

[[nodiscard]] bool hasFailure(const std::vector<Finding>& findings);

/// Sorts findings by severity, then by their place in `order`, and keeps the first failure. The ids
/// of the other failures become its evidence; warnings and notes follow.
/// @param order  The task's table; findings outside it come last.
[[nodiscard]] std::vector<Finding> mostImportantFirst(std::vector<Finding> findings,
                                                      std::span<const FindingText* const> order);

/// Failed if one of the findings fails, passed otherwise.
/// @param needsReview  Used if no finding fails.
[[nodiscard]] TaskJudgement judgementOf(std::vector<Finding> findings,
                                        std::span<const FindingText* const> order,
                                        bool needsReview = false);

/// The note that the rays are not visible, so that only values or pictures are judged.
/// @param what  The reason, as a clause.
[[nodiscard]] Finding unseenRays(const FindingText& text, const std::string& what);

}  // namespace ticker::tasks

#endif
