#ifndef TICKER_BASE_TRIMMED_H
#define TICKER_BASE_TRIMMED_H

#include <string_view>

namespace ticker {

/// A text without the ASCII white space at both ends.
[[nodiscard]] inline std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kSpace = " \t\n\v\f\r";
    const std::size_t first = text.find_first_not_of(kSpace);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

}  // namespace ticker

#endif
