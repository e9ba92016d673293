#ifndef TICKER_REPORT_WORDS_H
#define TICKER_REPORT_WORDS_H

#include <grader/result/SubmissionResult.h>

#include <string>
#include <string_view>

namespace ticker::report {

/// The submitted picture among SubmissionResult::pictures.
inline constexpr std::string_view kScreenshotFile = "images/screenshot.png";

/// For people: "not awarded", "needs a look", ...
[[nodiscard]] std::string_view wordsFor(Verdict verdict);
/// For people: "not attempted", ...
[[nodiscard]] std::string_view wordsFor(TaskState state);

/// For people: "mistake", "warning", "note".
[[nodiscard]] std::string_view wordsFor(Severity severity);

/// "worstLatitude" as "worst latitude".
[[nodiscard]] std::string spelledOut(std::string_view key);

}  // namespace ticker::report

#endif
