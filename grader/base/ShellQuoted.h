#ifndef TICKER_BASE_SHELLQUOTED_H
#define TICKER_BASE_SHELLQUOTED_H

#include <string>
#include <string_view>

namespace ticker {

/// A text between single quotes that are already there.
[[nodiscard]] inline std::string insideSingleQuotes(std::string_view text) {
    std::string safe;
    for (const char c : text)
        safe += c == '\'' ? "'\\''" : std::string{c};
    return safe;
}

/// One word of a shell's command line: the text as it is where no character of it means something
/// to a shell, otherwise in single quotes.
[[nodiscard]] inline std::string shellQuoted(std::string_view text) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=,:+@%";
    if (!text.empty() && text.find_first_not_of(kPlain) == std::string_view::npos)
        return std::string{text};
    return "'" + insideSingleQuotes(text) + "'";
}

}  // namespace ticker

#endif
