#ifndef TICKER_SELFTEST_MISTAKETABLES_H
#define TICKER_SELFTEST_MISTAKETABLES_H

#include <grader/build/Kit.h>
#include <grader/corpus/Entry.h>
#include <grader/exercise/Exercise.h>
#include <grader/sandbox/Sandbox.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ticker::selftest {

/// Options of a run of the catalogue.
struct MistakeRun {
    const Exercise* exercise = &defaultExercise();
    double fraction = 1.0;   ///< share of the entries, evenly picked; at least one
    std::uint64_t seed = 1;  ///< of the decision and of the choice of entries
    int jobs = 2;
    /// Called after each entry, one call at a time; may be null.
    std::function<void(std::size_t done, std::size_t of)> progress;
};

/// Result of one entry.
struct MistakeRow {
    corpus::Entry entry;
    std::string seen;         ///< "failed shadow.hard", or the compiler's first words
    bool asExpected = false;  ///< the entry's task and all others of its file
    double probeMs = 0.0;     ///< CPU of the submission's process
    double judgeMs = 0.0;     ///< CPU of the judgement itself
};

/// The entries of `catalogue` that are about one of these tasks.
[[nodiscard]] std::vector<corpus::Entry> mistakesOf(const std::vector<corpus::Entry>& catalogue,
                                                    const std::vector<std::string>& tasks);

/// The entries with these ids; "TASK/hard" also names the task.
/// @throws raytracer::InputError for an unknown id, with the nearest id.
[[nodiscard]] std::vector<corpus::Entry> mistakesCalled(const std::vector<corpus::Entry>& catalogue,
                                                        const std::vector<std::string>& ids);

/// Applies each mistake or accepted reading, compiles it and judges it. An entry that does not
/// compile is not as expected.
/// @throws raytracer::InputError if any entry's edit does not apply.
[[nodiscard]] std::vector<MistakeRow> runMistakes(const std::vector<corpus::Entry>& entries,
                                                  const build::Kit& kit,
                                                  const sandbox::Sandbox& sandbox,
                                                  const MistakeRun& run);

/// One line for each row, with marks on those that differ, and a summary.
[[nodiscard]] std::string tableOf(const std::vector<MistakeRow>& rows);

}  // namespace ticker::selftest

#endif
