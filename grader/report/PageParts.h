#ifndef TICKER_REPORT_PAGEPARTS_H
#define TICKER_REPORT_PAGEPARTS_H

#include <grader/result/SubmissionResult.h>

#include <string>
#include <string_view>

namespace ticker::report {

// Parts of the pages, as HTML. What came from a student is escaped in them.

/// A word on a coloured ground; `kind` is one of the words of result.json.
[[nodiscard]] std::string badge(std::string_view kind, std::string_view words);

/// A path of our own naming, for an attribute: everything unusual percent-encoded.
[[nodiscard]] std::string address(std::string_view path);

/// The head of a page up to and with the opening of its body.
[[nodiscard]] std::string pageHead(std::string_view title, std::string_view css);

/// One finding with its message, hint, pictures and measured values.
[[nodiscard]] std::string findingCard(const Finding& finding);

/// Expected and submitted pictures; empty where there are none.
[[nodiscard]] std::string picturesSection(const SubmissionResult& result);

/// What the compiler said, beside the student's lines; empty where it said nothing.
[[nodiscard]] std::string diagnosticsSection(const SubmissionResult& result);

}  // namespace ticker::report

#endif
