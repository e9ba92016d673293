#ifndef TICKER_TASKS_FINDINGTABLES_H
#define TICKER_TASKS_FINDINGTABLES_H

#include <grader/result/FindingText.h>

#include <span>
#include <string_view>

namespace ticker::tasks {

/// The findings of one task, in the order in which they are reported.
struct FindingTable {
    std::string_view heading;  ///< of its table in docs/findings.md: the task's id
    std::span<const FindingText* const> findings;
};

/// The tables of all exercises' tasks, of screenshots, and last the one of general findings.
[[nodiscard]] std::span<const FindingTable> findingTables();

/// Every finding once: the findings of each task in the order in which they are reported, then the
/// general ones. docs/findings.md is generated from this list.
[[nodiscard]] std::span<const FindingText* const> allFindings();

/// @return  The text of this id; null if no finding has it.
[[nodiscard]] const FindingText* findText(std::string_view id);

}  // namespace ticker::tasks

#endif
