#include <grader/session/Highlight.h>

#include <grader/report/Escape.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace ticker::session {
namespace {

constexpr std::array<std::string_view, 76> kKeywords{
    "alignas",      "alignof",  "auto",         "bool",        "break",     "case",
    "catch",        "char",     "class",        "co_await",    "co_return", "co_yield",
    "concept",      "const",    "const_cast",   "consteval",   "constexpr", "constinit",
    "continue",     "decltype", "default",      "delete",      "do",        "double",
    "dynamic_cast", "else",     "enum",         "explicit",    "export",    "extern",
    "false",        "final",    "float",        "for",         "friend",    "goto",
    "if",           "inline",   "int",          "long",        "mutable",   "namespace",
    "new",          "noexcept", "nullptr",      "operator",    "override",  "private",
    "protected",    "public",   "register",     "requires",    "return",    "short",
    "signed",       "sizeof",   "static",       "static_cast", "struct",    "switch",
    "template",     "this",     "thread_local", "throw",       "true",      "try",
    "typedef",      "typename", "union",        "unsigned",    "using",     "virtual",
    "void",         "volatile", "wchar_t",      "while"};

bool isWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool isDigit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

struct Token {
    std::string_view text;
    char kind = ' ';  ///< class in HTML; ' ' for none
};

/// Splits a source into the tokens that highlighting distinguishes.
class Scanner {
public:
    explicit Scanner(std::string_view source) : rest_(source) {}

    [[nodiscard]] bool isDone() const { return rest_.empty(); }

    Token next() {
        const bool first = std::exchange(atLineStart_, false);
        if (rest_.starts_with("//")) return lineComment();
        if (rest_.starts_with("/*")) return take(through("*/", 2), 'c');
        if (first && rest_.starts_with("#")) return take(endOfLine(), 'p');
        if (rest_.starts_with("R\"")) return take(rawString(), 's');
        if (rest_.front() == '"' || rest_.front() == '\'') return take(quoted(rest_.front()), 's');
        if (isDigit(rest_.front())) return take(number(), 'n');
        if (isWord(rest_.front())) return word();
        atLineStart_ =
            rest_.front() == '\n' || (first && (rest_.front() == ' ' || rest_.front() == '\t'));
        return take(1, ' ');
    }

private:
    Token take(std::size_t size, char kind) {
        const Token token{rest_.substr(0, size), kind};
        rest_.remove_prefix(token.text.size());
        return token;
    }

    [[nodiscard]] std::size_t endOfLine() const { return std::min(rest_.find('\n'), rest_.size()); }

    [[nodiscard]] std::size_t through(std::string_view end, std::size_t from) const {
        const std::size_t at = rest_.find(end, from);
        return at == std::string_view::npos ? rest_.size() : at + end.size();
    }

    Token lineComment() {
        const std::size_t size = endOfLine();
        const bool isMark = rest_.substr(0, size).starts_with("// TASK ");
        return take(size, isMark ? 'm' : 'c');
    }

    // A quote that is not closed ends with its line, so that one mistake does not colour the rest.
    [[nodiscard]] std::size_t quoted(char quote) const {
        for (std::size_t i = 1; i < rest_.size() && rest_[i] != '\n'; ++i) {
            if (rest_[i] == '\\')
                ++i;
            else if (rest_[i] == quote)
                return i + 1;
        }
        return endOfLine();
    }

    [[nodiscard]] std::size_t rawString() const {
        constexpr std::size_t kLongestDelimiter = 16;
        const std::size_t open = rest_.find('(', 2);
        if (open == std::string_view::npos || open > 2 + kLongestDelimiter) return 2;
        return through(")" + std::string{rest_.substr(2, open - 2)} + "\"", open);
    }

    // 0x1p-3, 1'000, 2.5e+7f: a sign belongs to it after an exponent.
    [[nodiscard]] std::size_t number() const {
        std::size_t i = 1;
        for (; i < rest_.size(); ++i) {
            const bool afterExponent =
                std::string_view{"eEpP"}.find(rest_[i - 1]) != std::string_view::npos;
            const bool isSign = (rest_[i] == '+' || rest_[i] == '-') && afterExponent;
            const bool isSeparator =
                rest_[i] == '\'' && i + 1 < rest_.size() && isWord(rest_[i + 1]);
            if (!isWord(rest_[i]) && rest_[i] != '.' && !isSign && !isSeparator) break;
        }
        return i;
    }

    Token word() {
        const auto end = std::ranges::find_if_not(rest_, isWord);
        const auto size = static_cast<std::size_t>(end - rest_.begin());
        const bool isKeyword =
            std::ranges::find(kKeywords, rest_.substr(0, size)) != kKeywords.end();
        return take(size, isKeyword ? 'k' : ' ');
    }

    std::string_view rest_;
    bool atLineStart_ = true;
};

void append(std::string& html, const Token& token) {
    std::string_view text = token.text;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::string part = report::escapeHtml(text.substr(0, end));
        if (token.kind == ' ' || part.empty())
            html += part;
        else
            html += std::string{"<i class=\""} + token.kind + "\">" + part + "</i>";
        if (end == std::string_view::npos) return;
        html += "</span>\n<span class=\"line\">";
        text.remove_prefix(end + 1);
    }
}

}  // namespace

std::string highlightCpp(std::string_view source) {
    const std::string clean = cleanText(source);
    std::string_view text{clean};
    if (text.ends_with('\n')) text.remove_suffix(1);
    std::string html = "<span class=\"line\">";
    for (Scanner scanner{text}; !scanner.isDone();)
        append(html, scanner.next());
    return html + "</span>";
}

}  // namespace ticker::session
