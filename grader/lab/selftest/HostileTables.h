#ifndef TICKER_SELFTEST_HOSTILETABLES_H
#define TICKER_SELFTEST_HOSTILETABLES_H

#include <grader/corpus/Entry.h>
#include <grader/lab/selftest/Traces.h>
#include <grader/pipeline/Grade.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ticker::selftest {

/// How much of the hostile corpus to run, and how.
struct HostileRun {
    double fraction = 1.0;   ///< share of the cases, evenly picked; at least one
    std::uint64_t seed = 1;  ///< of the decisions
    int jobs = 2;            ///< submissions at a time
    int rounds = 1;          ///< how often to run all that
    std::function<void(std::size_t done, std::size_t of)>
        progress;  ///< one call at a time; or null
};

/// What became of one hostile submission.
struct HostileRow {
    std::string name;
    int round = 0;
    std::string expected;             ///< states, findings and verdicts that are right
    std::string got;                  ///< state, findings and verdict
    std::vector<std::string> faults;  ///< what must not be, in a few words each
};

struct HostileTables {
    std::vector<HostileRow> rows;
    Footprint before;  ///< once one submission has been graded
    Footprint after;

    /// How many rows have no fault.
    [[nodiscard]] std::size_t right() const;
    /// All rows are right and nothing is left behind.
    [[nodiscard]] bool passed() const;
    /// One line for each row of the first round and each with faults, the latter told in full, and
    /// a summary.
    [[nodiscard]] std::string table() const;
};

/// Grades hostile submissions as a class, and looks for what each left behind: a secret that was
/// planted for them in the result, a file where they meant to write one, a process.
///
/// Processes are told by the uids that only jails have; at level C, where jails have none, only
/// what became a child of this process is found, at the end.
///
/// @param grader  Short limits save time: see grader/corpus/hostile/limits.json.
/// @throws raytracer::Error where the submissions cannot be written.
[[nodiscard]] HostileTables runHostileTables(const std::vector<corpus::Entry>& corpus,
                                             const pipeline::Grader& grader, const HostileRun& run);

}  // namespace ticker::selftest

#endif
