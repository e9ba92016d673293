#ifndef TICKER_BASE_UTF8_H
#define TICKER_BASE_UTF8_H

#include <string>
#include <string_view>

namespace ticker {

/// The text as valid UTF-8 that cannot move a terminal's cursor or pretend to be other text. CR LF
/// becomes a newline. Broken sequences, bidirectional controls, control characters except tab and
/// newline, and the last two code points of each plane (U+FFFE, U+FFFF, ...) become U+FFFD.
[[nodiscard]] std::string cleanText(std::string_view text);

/// `text` with every byte that is not part of valid UTF-8, and every NUL, as U+FFFD.
[[nodiscard]] std::string asUtf8(std::string_view text);

/// The same as `asUtf8`, as one line: all control characters, newlines included, and the separators
/// U+2028 and U+2029 become U+FFFD.
[[nodiscard]] std::string asPlainLine(std::string_view text);

/// The text with the letters A to Z in lower case; every other byte stays as it is.
[[nodiscard]] std::string lowerCase(std::string text);

}  // namespace ticker

#endif
