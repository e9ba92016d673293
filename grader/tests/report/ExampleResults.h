#ifndef TICKER_TESTS_REPORT_EXAMPLERESULTS_H
#define TICKER_TESTS_REPORT_EXAMPLERESULTS_H

#include <grader/result/SubmissionResult.h>

#include <vector>

namespace ticker::report {

/// Both tasks of option 2 and option 1 passed.
[[nodiscard]] SubmissionResult passedExample();
/// One axis of the bump map inverted: relief, pictures, evidence.
[[nodiscard]] SubmissionResult failedBumpExample();
/// A disc as aperture, with a warning, and no screenshot.
[[nodiscard]] SubmissionResult failedLensExample();
/// A file that does not compile: diagnostics with source lines.
[[nodiscard]] SubmissionResult blockedExample();
/// Hostile values in everything that a student can choose: markup, formulas, control characters.
[[nodiscard]] SubmissionResult hostileExample();

/// A file that does not compile, so that there is no code to compare the screenshot with.
[[nodiscard]] SubmissionResult notCheckedExample();
/// Renderer.cpp does not compile: both of its tasks have the same text.
[[nodiscard]] SubmissionResult saidTwiceExample();
/// Only a text was handed in: every task has the same text.
[[nodiscard]] SubmissionResult textOnlyExample();
/// Right, but without a screenshot: a ticker decides.
[[nodiscard]] SubmissionResult reviewExample();
/// An error of the grader: in one task, or in all.
[[nodiscard]] SubmissionResult notGradedExample();
[[nodiscard]] SubmissionResult nothingGradedExample();

/// `count` results of a class made from these.
[[nodiscard]] std::vector<SubmissionResult> exampleClass(int count);

}  // namespace ticker::report

#endif
