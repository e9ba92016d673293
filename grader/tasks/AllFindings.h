#ifndef TICKER_TASKS_ALLFINDINGS_H
#define TICKER_TASKS_ALLFINDINGS_H

#include <grader/result/FindingText.h>

#include <span>
#include <string_view>

namespace ticker::tasks {

/// Every finding once: those of each task in the order in which they are reported, then the general
/// ones. docs/findings.md is made from it.
[[nodiscard]] std::span<const FindingText* const> allFindings();

/// @return  Null where no finding has this id.
[[nodiscard]] const FindingText* findText(std::string_view id);

}  // namespace ticker::tasks

#endif
