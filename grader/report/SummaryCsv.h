#ifndef TICKER_REPORT_SUMMARYCSV_H
#define TICKER_REPORT_SUMMARYCSV_H

#include <grader/exercise/Exercise.h>
#include <grader/result/Decision.h>
#include <grader/result/SubmissionResult.h>

#include <string>
#include <vector>

namespace ticker::report {

/// The text of summary.csv: a header, then one line for each submission. First the tool's result:
/// submission, verdict, score, option, the state of each task, and the ids of its findings of
/// severity fail or warn, separated by spaces. Then the ticker's decision, or empty columns:
/// ruling ("awarded", "notYet"), name, time (UTC) and comment. Lines end in CR LF (RFC 4180).
/// @param exercise  The results' exercise.
[[nodiscard]] std::string summaryCsv(const std::vector<SubmissionResult>& results,
                                     const std::vector<Decision>& decisions,
                                     const Exercise& exercise);
/// The same for the exercise that the results name.
[[nodiscard]] std::string summaryCsv(const std::vector<SubmissionResult>& results,
                                     const std::vector<Decision>& decisions = {});

}  // namespace ticker::report

#endif
