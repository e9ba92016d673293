#ifndef TICKER_SELFTEST_HOSTILETABLES_H
#define TICKER_SELFTEST_HOSTILETABLES_H

#include <grader/corpus/Entry.h>
#include <grader/intake/Submission.h>
#include <grader/lab/selftest/Traces.h>
#include <grader/pipeline/Grade.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ticker::selftest {

/// Options of a run of the hostile corpus.
struct HostileRun {
    double fraction = 1.0;   ///< share of the cases, evenly picked; at least one
    std::uint64_t seed = 1;  ///< seed of the decisions
    int jobs = 2;            ///< submissions graded in parallel
    int rounds = 1;          ///< repetitions of the whole run
    /// Called with each graded submission before its traces are looked for, by several threads; may
    /// be null.
    std::function<void(const intake::Submission&, SubmissionResult&)> complete;
    /// Called after each submission, one call at a time; may be null.
    std::function<void(std::size_t done, std::size_t of)> progress;
};

/// Result of one hostile submission.
struct HostileRow {
    std::string name;
    int round = 0;
    std::string expected;             ///< the right states, findings and verdicts
    std::string got;                  ///< state, findings and verdict
    std::vector<std::string> faults;  ///< short descriptions of the faults
};

struct HostileTables {
    std::vector<HostileRow> rows;
    Footprint before;  ///< after the first graded submission
    Footprint after;

    /// Number of rows without faults.
    [[nodiscard]] std::size_t right() const;
    /// True if all rows are right and nothing is left behind.
    [[nodiscard]] bool passed() const;
    /// One line for each row of the first round and each faulty row, the latter with details, and a
    /// summary.
    [[nodiscard]] std::string table() const;
};

/// Grades hostile submissions as a class, and looks for traces of each: a planted secret in the
/// result, a file that the submission tried to write, a process.
///
/// Processes are recognised by the uids that only jails have. At level C jails have no such uids,
/// and only children of this process are found, at the end.
///
/// @param grader  Short limits save time: see grader/corpus/hostile/limits.json.
/// @throws raytracer::Error if the submissions cannot be written.
[[nodiscard]] HostileTables runHostileTables(const std::vector<corpus::Entry>& corpus,
                                             const pipeline::Grader& grader, const HostileRun& run);

}  // namespace ticker::selftest

#endif
