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

/// A file that does not compile, so that there is no code to compare the screenshot with.
[[nodiscard]] SubmissionResult notCheckedExample();
/// Renderer.cpp does not compile: the same is said of both of its tasks.
[[nodiscard]] SubmissionResult saidTwiceExample();
/// A text was handed in and nothing else: the same is said of every task.
[[nodiscard]] SubmissionResult textOnlyExample();
/// Right, but the screenshot is missing: a person decides.
[[nodiscard]] SubmissionResult reviewExample();
/// Our failure: in one task, or in all.
[[nodiscard]] SubmissionResult notGradedExample();
[[nodiscard]] SubmissionResult nothingGradedExample();

/// `count` results of a class made from these.
[[nodiscard]] std::vector<SubmissionResult> exampleClass(int count);

}  // namespace ticker::report

#endif
