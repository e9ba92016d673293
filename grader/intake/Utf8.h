#ifndef TICKER_INTAKE_UTF8_H
#define TICKER_INTAKE_UTF8_H

#include <string>
#include <string_view>

namespace ticker::intake {

/// `text` with every byte that is not part of valid UTF-8, and every NUL, as U+FFFD.
[[nodiscard]] std::string asUtf8(std::string_view text);

/// The same as one line: control characters, of which a newline is one, become U+FFFD, too.
[[nodiscard]] std::string asPlainLine(std::string_view text);

}  // namespace ticker::intake

#endif
