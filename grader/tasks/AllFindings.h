#ifndef TICKER_TASKS_ALLFINDINGS_H
#define TICKER_TASKS_ALLFINDINGS_H

#include <grader/result/FindingText.h>

#include <span>
#include <string_view>

namespace ticker::tasks {

/// Every finding once: the findings of each task in the order in which they are reported, then the
/// general ones. docs/findings.md is generated from this list.
[[nodiscard]] std::span<const FindingText* const> allFindings();

/// @return  The text of this id; null if no finding has it.
[[nodiscard]] const FindingText* findText(std::string_view id);

}  // namespace ticker::tasks

#endif
