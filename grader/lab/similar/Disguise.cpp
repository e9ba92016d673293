#include <grader/lab/similar/Disguise.h>
#include <grader/lab/similar/TokenText.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

namespace ticker::similar {
namespace {

using Kind = Token::Kind;
using Tokens = std::vector<Token>;

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream{text};
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

std::string withOtherNames(const std::string& source, const std::set<std::string>& known) {
    Tokens tokens = tokensOf(source);
    std::map<std::string, std::string> names;
    for (Token& token : tokens) {
        if (token.kind != Kind::word || known.contains(token.text)) continue;
        const auto [name, isNew] = names.try_emplace(token.text, "");
        if (isNew) name->second = "value" + std::to_string(names.size());
        token.text = name->second;
    }
    return sourceOf(tokens);
}

std::string withOtherComments(const std::string& source) {
    Tokens tokens = tokensOf(source);
    for (Token& token : tokens) {
        const bool isTaskMark = token.text.find("TASK") != std::string::npos;
        if (token.kind == Kind::comment && !isTaskMark) token.text.clear();
        if (token.kind == Kind::space)
            token.text = token.text.find('\n') != std::string::npos ? "\n\t" : " ";
        if (token.text == ";") token.text = "\n\t\t;  // next\n";
        if (token.text == "{") token.text = "\n{";
    }
    return sourceOf(tokens);
}

/// What a line or function declares: the word before the first "=" or "(".
std::string declaredIn(const std::string& text) {
    std::string last;
    for (const Token& token : tokensOf(text)) {
        if (token.kind == Kind::word) last = token.text;
        if (token.text == "=" || token.text == "(") return last;
    }
    return {};
}

bool isWholeDeclaration(const std::string& line) {
    const std::size_t start = line.find_first_not_of(' ');
    return start != std::string::npos && line.compare(start, 6, "const ") == 0 &&
           line.ends_with(';') && line.find(" = ") != std::string::npos;
}

/// Exchanges neighbours where the second does not need what the first declares.
void exchangeNeighbours(std::vector<std::string>& parts, bool (*isMovable)(const std::string&)) {
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
        if (!isMovable(parts[i]) || !isMovable(parts[i + 1])) continue;
        if (wordsOf(parts[i + 1]).contains(declaredIn(parts[i]))) continue;
        std::swap(parts[i], parts[i + 1]);
        ++i;
    }
}

/// Splits the text into functions and the pieces between them.
std::vector<std::string> functionsOf(const std::string& source) {
    std::vector<std::string> parts(1);
    for (const std::string& line : linesOf(source)) {
        const bool isStart = parts.back().empty() || line.empty();
        if (isStart && !parts.back().empty() && parts.back().ends_with("}\n")) parts.emplace_back();
        parts.back() += line + "\n";
        if (line == "}") parts.emplace_back();
    }
    return parts;
}

bool isFunction(const std::string& part) {
    return part.ends_with("\n}\n") && part.find("namespace") == std::string::npos;
}

std::string inOtherOrder(const std::string& source) {
    std::vector<std::string> lines = linesOf(source);
    exchangeNeighbours(lines, isWholeDeclaration);
    std::string text;
    for (const std::string& line : lines)
        text += line + "\n";
    std::vector<std::string> functions = functionsOf(text);
    exchangeNeighbours(functions, isFunction);
    text.clear();
    for (const std::string& function : functions)
        text += function;
    return text;
}

bool isOperand(const Token& token) {
    return token.kind == Kind::word || token.kind == Kind::number;
}

bool isOneOf(const Token& token, std::string_view marks) {
    return token.text.size() == 1 && marks.find(token.text) != std::string_view::npos;
}

Tokens withoutSpace(const std::string& source) {
    Tokens tokens = tokensOf(source);
    std::erase_if(tokens, [](const Token& token) {
        return token.kind == Kind::comment && token.text.find("TASK") == std::string::npos;
    });
    return tokens;
}

/// The index of the next token that is no space.
std::size_t after(const Tokens& tokens, std::size_t at) {
    do
        ++at;
    while (at < tokens.size() && tokens[at].kind == Kind::space);
    return std::min(at, tokens.size() - 1);
}

/// "x += e;" as "x = x + (e);", "++i" as "i += 1", "a < b" as "b > a", "(a * b" as "(b * a".
void rewriteAt(Tokens& tokens, std::size_t at) {
    const std::size_t next = after(tokens, at);
    const std::size_t last = after(tokens, next);
    Token& first = tokens[at];
    Token& mark = tokens[next];
    Token& second = tokens[last];
    if (first.text == "++" && mark.kind == Kind::word) {
        first.text.clear();
        mark.text += " += 1";
    } else if (first.kind == Kind::word && (mark.text == "+=" || mark.text == "-=")) {
        const std::string sign = mark.text.substr(0, 1);
        std::size_t end = last;
        while (end + 1 < tokens.size() && !isOneOf(tokens[end], ";"))
            ++end;
        mark.text = "= " + first.text + " " + sign + " (";
        tokens[end].text = ")" + tokens[end].text;
    } else if (isOperand(first) && isOperand(second) && isOneOf(mark, "*+<")) {
        const std::size_t end = after(tokens, last);
        if (!isOneOf(tokens[end], ",;)")) return;
        std::swap(first, second);
        if (mark.text == "<") mark.text = ">";
    }
}

std::string withOtherExpressions(const std::string& source) {
    Tokens tokens = withoutSpace(source);
    std::string before = ";";
    bool isSecondConst = false;
    for (std::size_t at = 0; at + 3 < tokens.size(); ++at) {
        if (tokens[at].kind == Kind::space) continue;
        if (tokens[at].text == "const" && (isSecondConst = !isSecondConst)) tokens[at].text.clear();
        if (std::string_view{";{}(=,"}.find(before.back()) != std::string_view::npos)
            rewriteAt(tokens, at);
        if (!tokens[at].text.empty()) before = tokens[at].text;
    }
    return sourceOf(tokens);
}

std::string mergedFrom(const std::string& source, const std::string& other) {
    const std::vector<std::string> first = linesOf(source);
    const std::vector<std::string> second = linesOf(other);
    std::string text;
    for (std::size_t i = 0; i < first.size() / 2; ++i)
        text += first[i] + "\n";
    for (std::size_t i = second.size() / 2; i < second.size(); ++i)
        text += second[i] + "\n";
    return text;
}

}  // namespace

std::string_view toString(Disguise disguise) {
    switch (disguise) {
        case Disguise::names:
            return "names";
        case Disguise::order:
            return "order";
        case Disguise::comments:
            return "comments and layout";
        case Disguise::expressions:
            return "expressions";
        case Disguise::parts:
            return "half of it another's";
    }
    return "";
}

std::set<std::string> wordsOf(std::string_view source) {
    std::set<std::string> words;
    for (Token& token : tokensOf(source))
        if (token.kind == Kind::word) words.insert(std::move(token.text));
    return words;
}

std::string disguised(Disguise disguise, const std::string& source,
                      const std::set<std::string>& known, const std::string& other) {
    switch (disguise) {
        case Disguise::names:
            return withOtherNames(source, known);
        case Disguise::order:
            return inOtherOrder(source);
        case Disguise::comments:
            return withOtherComments(source);
        case Disguise::expressions:
            return withOtherExpressions(source);
        case Disguise::parts:
            return mergedFrom(source, other);
    }
    return source;
}

}  // namespace ticker::similar
