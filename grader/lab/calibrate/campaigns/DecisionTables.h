#ifndef TICKER_CALIBRATE_DECISIONTABLES_H
#define TICKER_CALIBRATE_DECISIONTABLES_H

#include <grader/lab/calibrate/Campaign.h>
#include <grader/lab/calibrate/Subject.h>

#include <string>
#include <vector>

namespace ticker::calibrate {

/// Counts, bounds of 95 % confidence and CPU times, as Markdown. A decision on a subject covers all
/// tasks that were judged in it; the subjects are all right or all wrong. Expected of right ones:
/// none fails, and at most one in 1,000 needs a person's review. Expected of wrong ones: none is
/// missed, and at most one in 50 has another name.
[[nodiscard]] Summary tablesOf(const std::vector<Subject>& subjects,
                               const std::vector<std::string>& records);

/// A row for each task, for exact verdicts. Expected: no right one fails, no mistake passes, and
/// every mistake gets its name.
[[nodiscard]] Summary exactTables(const std::vector<Subject>& subjects,
                                  const std::vector<std::string>& records);

}  // namespace ticker::calibrate

#endif
