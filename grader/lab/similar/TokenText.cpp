#include <grader/lab/similar/TokenText.h>
#include <grader/repair/candidates/Tokens.h>

#include <algorithm>
#include <cctype>

namespace ticker::similar {
namespace {

using Kind = Token::Kind;

constexpr std::string_view kBlanks = " \t\r\n\v\f";

std::size_t endOfComment(std::string_view text) {
    const std::string_view end = text.starts_with("//") ? "\n" : "*/";
    const std::size_t found = text.find(end, 2);
    if (found == std::string_view::npos) return text.size();
    return end == "\n" ? found : found + end.size();
}

/// What stands between two tokens: white space and comments.
void addGap(std::vector<Token>& tokens, std::string_view gap) {
    while (!gap.empty()) {
        const bool isSpace = kBlanks.find(gap.front()) != std::string_view::npos;
        const std::size_t size =
            isSpace ? std::min(gap.find_first_not_of(kBlanks), gap.size()) : endOfComment(gap);
        tokens.push_back({isSpace ? Kind::space : Kind::comment, std::string{gap.substr(0, size)}});
        gap.remove_prefix(size);
    }
}

Kind kindOf(std::string_view token) {
    const auto first = static_cast<unsigned char>(token.front());
    if (first == '"' || first == '\'') return Kind::text;
    if (std::isdigit(first) != 0 || (first == '.' && token.size() > 1 && token[1] != '.'))
        return Kind::number;
    return std::isalpha(first) != 0 || first == '_' ? Kind::word : Kind::mark;
}

}  // namespace

std::vector<Token> tokensOf(std::string_view source) {
    std::vector<Token> tokens;
    std::size_t at = 0;
    for (const candidates::Range& range : candidates::tokensOf(source)) {
        if (range.begin < at) continue;  // a part of a directive
        addGap(tokens, source.substr(at, range.begin - at));
        std::string_view text = source.substr(range.begin, range.size());
        const bool isDirective = text == "#";
        if (isDirective) {
            text = source.substr(range.begin);
            text = text.substr(0, text.find('\n'));
        }
        tokens.push_back({isDirective ? Kind::directive : kindOf(text), std::string{text}});
        at = range.begin + text.size();
    }
    addGap(tokens, source.substr(at));
    return tokens;
}

std::string sourceOf(const std::vector<Token>& tokens) {
    std::string source;
    for (const Token& token : tokens)
        source += token.text;
    return source;
}

}  // namespace ticker::similar
