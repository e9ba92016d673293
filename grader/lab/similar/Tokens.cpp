#include <grader/lab/similar/Tokens.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace ticker::similar {
namespace {

using Kind = Token::Kind;

bool isLetter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool isDigit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}
bool isSpace(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

std::size_t endOfLine(std::string_view text) {
    return std::min(text.find('\n'), text.size());
}

std::size_t endOfString(std::string_view text) {
    std::size_t at = 1;
    while (at < text.size() && text[at] != text[0])
        at += text[at] == '\\' ? 2 : 1;
    return std::min(at + 1, text.size());
}

std::size_t endOfComment(std::string_view text) {
    const std::size_t end = text.find("*/", 2);
    return end == std::string_view::npos ? text.size() : end + 2;
}

template <class IsIn>
std::size_t lengthOf(std::string_view text, IsIn isIn) {
    return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), isIn) -
                                    text.begin());
}

std::size_t lengthOfMark(std::string_view text) {
    constexpr std::array<std::string_view, 17> kLong{"+=", "-=", "*=", "/=", "++", "--",
                                                     "==", "!=", "<=", ">=", "->", "::",
                                                     "&&", "||", "<<", ">>", "%="};
    return std::ranges::find(kLong, text.substr(0, 2)) != kLong.end() ? 2 : 1;
}

Token firstOf(std::string_view text) {
    const char c = text.front();
    const auto piece = [&](Kind kind, std::size_t length) {
        return Token{kind, std::string{text.substr(0, length)}};
    };
    if (isSpace(c)) return piece(Kind::space, lengthOf(text, isSpace));
    if (text.starts_with("//")) return piece(Kind::comment, endOfLine(text));
    if (text.starts_with("/*")) return piece(Kind::comment, endOfComment(text));
    if (c == '#') return piece(Kind::directive, endOfLine(text));
    if (c == '"' || c == '\'') return piece(Kind::text, endOfString(text));
    if (isDigit(c) || (c == '.' && text.size() > 1 && isDigit(text[1]))) {
        const auto isInNumber = [](char each) {
            return isLetter(each) || each == '.' || each == '\'';
        };
        return piece(Kind::number, lengthOf(text, isInNumber));
    }
    if (isLetter(c)) return piece(Kind::word, lengthOf(text, isLetter));
    return piece(Kind::mark, lengthOfMark(text));
}

}  // namespace

std::vector<Token> tokensOf(std::string_view source) {
    std::vector<Token> tokens;
    while (!source.empty()) {
        tokens.push_back(firstOf(source));
        source.remove_prefix(tokens.back().text.size());
    }
    return tokens;
}

std::string sourceOf(const std::vector<Token>& tokens) {
    std::string source;
    for (const Token& token : tokens)
        source += token.text;
    return source;
}

}  // namespace ticker::similar
