#include <grader/intake/TaskText.h>

#include <grader/base/Trimmed.h>

#include <cctype>

namespace ticker::intake {
namespace {

bool isSpace(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool isClosedComment(std::string_view text) {
    return text.size() >= std::string_view{"/**/"}.size() && text.ends_with("*/");
}

/// The word, perhaps of digits, that a text ends with; it may be empty.
std::string_view wordAtEnd(std::string_view text) {
    std::size_t begin = text.size();
    while (begin > 0 && isWordCharacter(text[begin - 1]))
        --begin;
    return text.substr(begin);
}

/// A comment, a string or character literal, or a single character of C++ source.
struct Piece {
    enum class Kind { comment, literal, character };
    Kind kind = Kind::character;
    std::string_view text;
};

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

/// @param rest  From the quote after the R.
std::string_view rawString(std::string_view rest) {
    const std::size_t open = rest.find('(');
    constexpr std::size_t kLongestDelimiter = 16;
    if (open == std::string_view::npos || open > kLongestDelimiter + 1) return quoted(rest);
    return upTo(")" + std::string{rest.substr(1, open - 1)} + "\"", rest, open);
}

/// Whether a quote after this word begins a raw string: R"(...)", also u8R, uR, UR, LR.
bool isRawPrefix(std::string_view word) {
    return word == "R" || word == "u8R" || word == "uR" || word == "UR" || word == "LR";
}

/// Whether a quote after this word is a digit separator, as in 1'000: it begins no literal.
bool isInNumber(std::string_view word) {
    return !word.empty() && std::isxdigit(static_cast<unsigned char>(word.back())) != 0 &&
           word != "u8";
}

/// The piece of a source that begins at a place before its end.
Piece pieceAt(std::size_t at, std::string_view source) {
    const std::string_view before = source.substr(0, at);
    const std::string_view rest = source.substr(at);
    if (rest.starts_with("//")) return {Piece::Kind::comment, lineComment(rest)};
    if (rest.starts_with("/*")) return {Piece::Kind::comment, upTo("*/", rest, 2)};
    if (rest.front() == '"')
        return {Piece::Kind::literal,
                isRawPrefix(wordAtEnd(before)) ? rawString(rest) : quoted(rest)};
    if (rest.front() == '\'' && !isInNumber(wordAtEnd(before)))
        return {Piece::Kind::literal, quoted(rest)};
    return {Piece::Kind::character, rest.substr(0, 1)};
}

}  // namespace

std::optional<std::string> taskText(std::string_view source, std::string_view task) {
    const std::string begin = "TASK " + std::string{task} + " begin";
    const std::string end = "TASK " + std::string{task} + " end";
    std::optional<std::string> text;
    for (std::size_t at = 0; at < source.size();) {
        const Piece piece = pieceAt(at, source);
        at += piece.text.size();
        if (piece.kind == Piece::Kind::comment) {
            const std::string_view comment = trimmed(piece.text.substr(2));
            if (comment == begin && !text) text.emplace();
            if (comment == end && text) return text;
        } else if (text && (piece.kind == Piece::Kind::literal || !isSpace(piece.text.front()))) {
            *text += piece.text;
        }
    }
    return std::nullopt;
}

bool isStub(std::string_view source, std::string_view templateSource, std::string_view task) {
    const std::optional<std::string> text = taskText(source, task);
    return text && text == taskText(templateSource, task);
}

bool holdsCode(std::string_view source) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (source.starts_with(kByteOrderMark)) source.remove_prefix(kByteOrderMark.size());
    for (std::size_t at = 0; at < source.size();) {
        const Piece piece = pieceAt(at, source);
        at += piece.text.size();
        const bool isBlank = piece.kind == Piece::Kind::comment
                                 ? !piece.text.starts_with("/*") || isClosedComment(piece.text)
                                 : piece.text.size() == 1 && isSpace(piece.text.front());
        if (!isBlank) return true;
    }
    return false;
}

}  // namespace ticker::intake
