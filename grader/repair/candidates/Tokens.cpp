#include <grader/repair/candidates/Tokens.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace ticker::candidates {
namespace {

bool isWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool isSpace(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// The end of the comment that begins at `at`; `at` itself if no comment begins there.
std::size_t endOfComment(std::string_view text, std::size_t at) {
    if (text.substr(at, 2) == "//") return std::min(text.find('\n', at), text.size());
    if (text.substr(at, 2) != "/*") return at;
    const std::size_t end = text.find("*/", at + 2);
    return end == std::string_view::npos ? text.size() : end + 2;
}

std::size_t endOfQuoted(std::string_view text, std::size_t at) {
    const char quote = text[at];
    for (std::size_t i = at + 1; i < text.size(); ++i) {
        if (text[i] == '\\')
            ++i;
        else if (text[i] == quote)
            return i + 1;
    }
    return text.size();
}

std::size_t endOfNumber(std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size()) {
        const bool isExponentSign = (text[end] == '+' || text[end] == '-') &&
                                    (text[end - 1] == 'e' || text[end - 1] == 'E');
        if (!isWord(text[end]) && text[end] != '.' && !isExponentSign) break;
        ++end;
    }
    return end;
}

std::size_t endOfSign(std::string_view text, std::size_t at) {
    static constexpr std::array<std::string_view, 21> kLong{
        "<<=", ">>=", "...", "->*", "::", "->", "++", "--", "<<", ">>", "<=",
        ">=",  "==",  "!=",  "&&",  "||", "+=", "-=", "*=", "/=", "%="};
    for (const std::string_view sign : kLong)
        if (text.substr(at, sign.size()) == sign) return at + sign.size();
    return at + 1;
}

std::size_t endOfToken(std::string_view text, std::size_t at) {
    const char c = text[at];
    if (c == '"' || c == '\'') return endOfQuoted(text, at);
    const bool isNumber = std::isdigit(static_cast<unsigned char>(c)) != 0 ||
                          (c == '.' && at + 1 < text.size() &&
                           std::isdigit(static_cast<unsigned char>(text[at + 1])) != 0);
    if (isNumber) return endOfNumber(text, at);
    if (!isWord(c)) return endOfSign(text, at);
    std::size_t end = at;
    while (end < text.size() && isWord(text[end]))
        ++end;
    return end;
}

}  // namespace

std::vector<Range> tokensOf(std::string_view text) {
    std::vector<Range> tokens;
    for (std::size_t at = 0; at < text.size();) {
        if (isSpace(text[at])) {
            ++at;
        } else if (const std::size_t end = endOfComment(text, at); end > at) {
            at = end;
        } else {
            tokens.push_back({at, endOfToken(text, at)});
            at = tokens.back().end;
        }
    }
    return tokens;
}

std::vector<std::string_view> wordsOf(std::string_view text) {
    std::vector<std::string_view> words;
    for (const Range& token : tokensOf(text))
        words.push_back(text.substr(token.begin, token.size()));
    return words;
}

std::vector<Range> Source::tokensIn(const Range& range) const {
    const auto first = std::ranges::lower_bound(tokens_, range.begin, {}, &Range::begin);
    std::vector<Range> found;
    for (auto token = first; token != tokens_.end() && token->end <= range.end; ++token)
        found.push_back(*token);
    return found;
}

std::size_t Source::lineOf(std::size_t offset) const {
    return 1 + static_cast<std::size_t>(std::count(
                   text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

}  // namespace ticker::candidates
