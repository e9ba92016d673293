#ifndef TICKER_REPORT_CLASSPAGE_H
#define TICKER_REPORT_CLASSPAGE_H

#include <grader/exercise/Exercise.h>
#include <grader/result/SubmissionResult.h>

#include <string>
#include <vector>

namespace ticker::report {

/// The text of index.html: an overview of a class, with links to `<submission>/report.html`.
/// @param exercise  The results' exercise.
[[nodiscard]] std::string classPage(const std::vector<SubmissionResult>& results,
                                    const Exercise& exercise);
/// The same for the exercise that the results name.
[[nodiscard]] std::string classPage(const std::vector<SubmissionResult>& results);

}  // namespace ticker::report

#endif
