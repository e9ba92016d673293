#ifndef TICKER_REPORT_ESCAPE_H
#define TICKER_REPORT_ESCAPE_H

#include <string>
#include <string_view>

namespace ticker::report {

/// Valid UTF-8: broken sequences become U+FFFD; control characters but tab and newline, and the
/// bidirectional overrides, become U+FFFD as well, so that text cannot move a terminal's cursor or
/// pretend to be other text.
[[nodiscard]] std::string cleanText(std::string_view text);

/// For HTML and XML text and quoted attributes.
[[nodiscard]] std::string escapeHtml(std::string_view text);

/// One CSV field (RFC 4180), quoted where needed; a leading = + - @ tab gets an apostrophe, so that
/// no spreadsheet takes it for a formula.
[[nodiscard]] std::string escapeCsv(std::string_view text);

/// One line for a terminal: clean, newlines and tabs become spaces.
[[nodiscard]] std::string escapeLine(std::string_view text);

}  // namespace ticker::report

#endif
