#include <grader/intake/SourcePiece.h>

#include <cctype>
#include <string>

namespace ticker::intake {
namespace {

bool isDigit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The word, perhaps of digits, that a text ends with; it may be empty.
std::string_view wordAtEnd(std::string_view text) {
    std::size_t begin = text.size();
    while (begin > 0 && isWordCharacter(text[begin - 1]))
        --begin;
    return text.substr(begin);
}

/// The beginning of a text, up to and with the first `end` from a place on.
std::string_view upTo(std::string_view end, std::string_view text, std::size_t from) {
    const std::size_t at = text.find(end, from);
    return at == std::string_view::npos ? text : text.substr(0, at + end.size());
}

bool endsInBackslash(std::string_view line) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line.ends_with('\\');
}

// A backslash at the end of its line continues a comment on the next one.
std::string_view lineComment(std::string_view rest) {
    std::size_t end = rest.find('\n');
    while (end != std::string_view::npos && endsInBackslash(rest.substr(0, end)))
        end = rest.find('\n', end + 1);
    return rest.substr(0, end);
}

std::string_view quoted(std::string_view rest) {
    const char quote = rest.front();
    for (std::size_t i = 1; i < rest.size(); ++i) {
        if (rest[i] == '\\')
            ++i;
        else if (rest[i] == quote)
            return rest.substr(0, i + 1);
        else if (rest[i] == '\n')
            return rest.substr(0, i);  // unterminated; the compiler reports it
    }
    return rest;
}

/// Whether a quote after this word begins a raw string: R"(...)", also u8R, uR, UR, LR.
bool isRawPrefix(std::string_view word) {
    return word == "R" || word == "u8R" || word == "uR" || word == "UR" || word == "LR";
}

/// The number at the beginning of a text, as in 0xA'B or 1.5e3: its separators begin no literal.
std::string_view numberAt(std::string_view rest) {
    std::size_t end = 1;
    while (end < rest.size() &&
           (isWordCharacter(rest[end]) || rest[end] == '.' ||
            (rest[end] == '\'' && end + 1 < rest.size() && isWordCharacter(rest[end + 1]))))
        ++end;
    return rest.substr(0, end);
}

}  // namespace

Piece pieceAt(std::size_t at, std::string_view source) {
    const std::string_view before = source.substr(0, at);
    const std::string_view rest = source.substr(at);
    if (rest.starts_with("//")) return {Piece::Kind::comment, lineComment(rest)};
    if (rest.starts_with("/*")) return {Piece::Kind::comment, upTo("*/", rest, 2)};
    if (rest.front() == '"' && isRawPrefix(wordAtEnd(before)))
        return {Piece::Kind::rawString, rawString(rest)};
    if (rest.front() == '"' || rest.front() == '\'') return {Piece::Kind::literal, quoted(rest)};
    if (isDigit(rest.front()) && (before.empty() || !isWordCharacter(before.back())))
        return {Piece::Kind::number, numberAt(rest)};
    return {Piece::Kind::character, rest.substr(0, 1)};
}

std::string_view rawString(std::string_view rest) {
    const std::size_t open = rest.find('(');
    constexpr std::size_t kLongestDelimiter = 16;
    if (open == std::string_view::npos || open > kLongestDelimiter + 1) return quoted(rest);
    return upTo(")" + std::string{rest.substr(1, open - 1)} + "\"", rest, open);
}

}  // namespace ticker::intake
