#ifndef TICKER_REPORT_REPORTWORDS_H
#define TICKER_REPORT_REPORTWORDS_H

#include <grader/result/SubmissionResult.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::report {

/// The screenshot among SubmissionResult::pictures.
inline constexpr std::string_view kScreenshotFile = "images/screenshot.png";

/// For readers: "not awarded", "needs a look", ...
[[nodiscard]] std::string_view wordsFor(Verdict verdict);
/// For readers: "not attempted", ...
[[nodiscard]] std::string_view wordsFor(TaskState state);

/// For readers: the words of its state, or "not checked".
[[nodiscard]] std::string_view wordsFor(const TaskReport& task);
/// For programs and style sheets: the state's name in result.json, or "notChecked".
[[nodiscard]] std::string_view kindOf(const TaskReport& task);

/// For readers: "mistake", "warning", "note".
[[nodiscard]] std::string_view wordsFor(Severity severity);

/// Words that continue "14 of 60 ...": "inverted the bumps along u". The id itself if it has no
/// words.
[[nodiscard]] std::string_view wordsForFinding(std::string_view id);

/// An earlier task with exactly the same text, which need not be repeated, or null.
/// @param task  A task of the result.
[[nodiscard]] const TaskReport* saidBefore(const SubmissionResult& result, const TaskReport& task);

/// "a", "a and b", "a, b and c".
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

/// "1 submission", "2 submissions".
[[nodiscard]] std::string counted(std::size_t count, std::string_view what);

/// The first letter as a capital.
[[nodiscard]] std::string sentence(std::string_view text);

/// "worstLatitude" as "worst latitude".
[[nodiscard]] std::string spelledOut(std::string_view key);

}  // namespace ticker::report

#endif
