#ifndef TICKER_REPORT_ESCAPE_H
#define TICKER_REPORT_ESCAPE_H

#include <grader/base/Utf8.h>

#include <string>
#include <string_view>

namespace ticker::report {

/// Escapes HTML and XML text and quoted attributes.
[[nodiscard]] std::string escapeHtml(std::string_view text);

/// One CSV field (RFC 4180), quoted if necessary. A leading = + - @ tab gets an apostrophe, so that
/// no spreadsheet reads it as a formula.
[[nodiscard]] std::string escapeCsv(std::string_view text);

/// One line for a terminal: control characters are removed, newlines and tabs become spaces.
[[nodiscard]] std::string escapeLine(std::string_view text);

}  // namespace ticker::report

#endif
