#ifndef TICKER_TESTS_REPORT_EXAMPLERESULTS_H
#define TICKER_TESTS_REPORT_EXAMPLERESULTS_H

#include <grader/result/SubmissionResult.h>

#include <vector>

namespace ticker::report {

/// Both tasks of option 2 and option 1 passed.
[[nodiscard]] SubmissionResult passedExample();
/// One axis of the bump map inverted: relief, pictures, evidence.
[[nodiscard]] SubmissionResult failedBumpExample();
/// A disc for an aperture, a warning beside it, the screenshot missing.
[[nodiscard]] SubmissionResult failedLensExample();
/// A file that does not compile: diagnostics with source lines.
[[nodiscard]] SubmissionResult blockedExample();
/// Everything that a student may choose is hostile: markup, formulas, control characters.
[[nodiscard]] SubmissionResult hostileExample();

/// `count` results of a class made from these.
[[nodiscard]] std::vector<SubmissionResult> exampleClass(int count);

}  // namespace ticker::report

#endif
