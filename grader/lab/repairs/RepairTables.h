#ifndef TICKER_LAB_REPAIRS_REPAIRTABLES_H
#define TICKER_LAB_REPAIRS_REPAIRTABLES_H

#include <grader/corpus/Entry.h>
#include <grader/pipeline/Grade.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ticker::lab {

/// How much of the corpus is tried.
struct RepairRun {
    double fraction = 1.0;  ///< every so many entries
    std::uint64_t seed = 1;
    std::function<void(std::size_t done, std::size_t of)> progress;
};

/// What came of one wrong submission.
struct RepairRow {
    std::string collection;  ///< "mistakes", "unseen" or "samples"
    std::string task;
    std::string name;
    bool isOneEdit = false;    ///< a mistake of the catalogue: one replacement of a few tokens
    bool isRepaired = false;   ///< at least one edit was proven
    bool isRightLine = false;  ///< the first one is in a line that the mistake's own edit changed
    double cpuMs = 0.0;
};

/// Grades each entry that is expected to fail one task, and looks for edits.
/// @param task  Only this one's; empty: all.
[[nodiscard]] std::vector<RepairRow> runRepairs(const std::vector<corpus::Entry>& entries,
                                                const std::string& task,
                                                const pipeline::Grader& grader,
                                                const RepairRun& run);

/// A line for each row.
[[nodiscard]] std::string listOf(const std::vector<RepairRow>& rows);
/// Rates and cost for each collection and task, in Markdown.
[[nodiscard]] std::string tableOf(const std::vector<RepairRow>& rows);
/// The whole document docs/repairs.md.
[[nodiscard]] std::string documentOf(const std::vector<RepairRow>& rows);

}  // namespace ticker::lab

#endif
