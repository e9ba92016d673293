#ifndef TICKER_TASKS_DISTRIBUTED_FINDINGTEXT_H
#define TICKER_TASKS_DISTRIBUTED_FINDINGTEXT_H

#include <grader/result/Finding.h>

#include <string>
#include <string_view>
#include <vector>

namespace ticker::tasks {

/// A finding of T2.1 or T2.2 with the hint and the handout's section that belong to its id.
/// @param seen  What was expected and what was seen: the message.
[[nodiscard]] Finding distributedFinding(std::string_view id, Severity severity, std::string seen);

[[nodiscard]] bool hasFailure(const std::vector<Finding>& findings);

/// Puts findings into the order of docs/findings.md and keeps the first failure: the names of the
/// others become its evidence, warnings and notes follow it.
[[nodiscard]] std::vector<Finding> mostImportantFirst(std::vector<Finding> findings);

}  // namespace ticker::tasks

#endif
