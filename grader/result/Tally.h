#ifndef TICKER_RESULT_TALLY_H
#define TICKER_RESULT_TALLY_H

#include <grader/result/SubmissionResult.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ticker {

/// Numbers of submissions by verdict, task and finding.
struct Tally {
    struct Task {
        int tried = 0;
        int passed = 0;
    };
    std::map<Verdict, int> verdicts;
    std::map<std::string, Task> tasks;                  ///< by id, without the screenshot
    std::vector<std::pair<std::string, int>> findings;  ///< by id, the most frequent first
};

[[nodiscard]] Tally tallyOf(const std::vector<SubmissionResult>& results);

/// The findings of a submission above a note, each once, in the order of its tasks.
[[nodiscard]] std::vector<std::string> findingIds(const SubmissionResult& result);

}  // namespace ticker

#endif
