#ifndef TICKER_REPORT_CLASSPAGE_H
#define TICKER_REPORT_CLASSPAGE_H

#include <grader/exercise/Exercise.h>
#include <grader/result/Decision.h>

#include <string>
#include <vector>

namespace ticker::report {

/// The text of index.html: an overview of a class, with links to `<submission>/report.html`.
/// @param exercise   The results' exercise.
/// @param decisions  The newest one about each submission that has one; they are counted.
[[nodiscard]] std::string classPage(const std::vector<SubmissionResult>& results,
                                    const Exercise& exercise,
                                    const std::vector<Decision>& decisions = {});
/// The same for the exercise that the results name.
[[nodiscard]] std::string classPage(const std::vector<SubmissionResult>& results,
                                    const std::vector<Decision>& decisions = {});

}  // namespace ticker::report

#endif
