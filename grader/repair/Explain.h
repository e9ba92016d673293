#ifndef TICKER_REPAIR_EXPLAIN_H
#define TICKER_REPAIR_EXPLAIN_H

#include <grader/intake/Submission.h>
#include <grader/pipeline/Grade.h>
#include <grader/repair/Clock.h>
#include <grader/repair/SearchLimits.h>
#include <grader/result/Repair.h>
#include <grader/result/SubmissionResult.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ticker::repair {

/// What was found for one submission, and what it took.
struct Explanation {
    std::vector<Repair> repairs;  ///< proven; the simplest of each task first
    double cpuMs = 0.0;           ///< CPU time of the explanation, ms
    /// The part of it that child processes took, by kind of work.
    std::map<Work, double> workMs;
    std::size_t tried = 0;            ///< sets of edits that were asked
    std::vector<std::string> cutOff;  ///< tasks without a repair whose time ended before all edits
                                      ///< were tried
    /// Tasks whose file could not be parsed, or not compiled with its edits.
    std::vector<std::string> notSearched;
};

/// Whether a task failed in a way that an edit of its file could mend.
[[nodiscard]] bool isExplainable(const TaskReport& task);

/// Looks for small edits of a submission with which its failed tasks pass. Nothing is run for a
/// submission without a failed task.
/// @param result  Its result without edits; the verdict never depends on what is found here.
/// @param seed    The questions are drawn from it: others than those of the result.
[[nodiscard]] Explanation explain(const intake::Submission& submission,
                                  const pipeline::Grader& grader, const SubmissionResult& result,
                                  std::uint64_t seed,
                                  const SearchLimits& limits = defaultSearchLimits());

}  // namespace ticker::repair

#endif
