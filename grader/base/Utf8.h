#ifndef TICKER_BASE_UTF8_H
#define TICKER_BASE_UTF8_H

#include <string>
#include <string_view>

namespace ticker {

/// Valid UTF-8: broken sequences become U+FFFD; control characters but tab and newline, and the
/// bidirectional overrides, become U+FFFD as well, so that text cannot move a terminal's cursor or
/// pretend to be other text.
[[nodiscard]] std::string cleanText(std::string_view text);

/// `text` with every byte that is not part of valid UTF-8, and every NUL, as U+FFFD.
[[nodiscard]] std::string asUtf8(std::string_view text);

/// The same as one line: control characters, of which a newline is one, become U+FFFD, too.
[[nodiscard]] std::string asPlainLine(std::string_view text);

/// The text with the letters A to Z in lower case; every other byte stays as it is.
[[nodiscard]] std::string lowerCase(std::string text);

}  // namespace ticker

#endif
