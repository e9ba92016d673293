#ifndef TICKER_BASE_UTF8_H
#define TICKER_BASE_UTF8_H

#include <string>
#include <string_view>

namespace ticker {

/// Valid UTF-8: broken sequences become U+FFFD; control characters but tab and newline, and the
/// bidirectional overrides, become U+FFFD as well, so that text cannot move a terminal's cursor or
/// pretend to be other text.
[[nodiscard]] std::string cleanText(std::string_view text);

}  // namespace ticker

#endif
