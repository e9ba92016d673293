#ifndef TICKER_SELFTEST_SCREENSHOTCASES_H
#define TICKER_SELFTEST_SCREENSHOTCASES_H

#include <grader/lab/selftest/ScreenshotTables.h>
#include <grader/result/SubmissionResult.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ticker::selftest {

/// One picture that is handed in.
struct ScreenshotCase {
    std::string kind;
    std::string name;
    std::string expected;  ///< expected finding; empty: none above a note
    /// Makes the picture and judges it. Sets the CPU time of the judgement, without other
    /// processes.
    std::function<TaskJudgement(double& judgeMs)> judge;
};

/// @param bench  Must outlive the cases.
[[nodiscard]] std::vector<ScreenshotCase> honestScreenshots(const ScreenshotBench& bench,
                                                            std::uint64_t seed);
[[nodiscard]] std::vector<ScreenshotCase> badScreenshots(const ScreenshotBench& bench,
                                                         std::uint64_t seed);

}  // namespace ticker::selftest

#endif
