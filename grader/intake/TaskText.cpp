#include <grader/intake/TaskText.h>

#include <cctype>

namespace ticker::intake {
namespace {

bool isSpace(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isSpace(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isSpace(text.back()))
        text.remove_suffix(1);
    return text;
}

bool isClosedComment(std::string_view text) {
    return text.size() >= std::string_view{"/**/"}.size() && text.ends_with("*/");
}

/// Splits C++ source into comments, literals and single characters.
class Lexer {
public:
    enum class Piece { comment, literal, character };

    explicit Lexer(std::string_view rest) : rest_(rest) {}

    /// Advances by one piece; false at the end.
    bool next() {
        remember();
        if (rest_.empty()) return false;
        piece_ = Piece::character;
        std::size_t size = 1;
        if (rest_.starts_with("//"))
            size = lineComment();
        else if (rest_.starts_with("/*"))
            size = blockComment();
        else if (rest_.front() == '"')
            size = isRawPrefix() ? rawString() : quoted('"');
        else if (rest_.front() == '\'' && !isInNumber())
            size = quoted('\'');
        text_ = rest_.substr(0, size);
        rest_.remove_prefix(text_.size());
        return true;
    }

    [[nodiscard]] Piece piece() const { return piece_; }
    [[nodiscard]] std::string_view text() const { return text_; }

private:
    std::size_t orAll(std::size_t at, std::size_t plus) const {
        return at == std::string_view::npos ? rest_.size() : at + plus;
    }

    std::size_t lineComment() {
        piece_ = Piece::comment;
        std::size_t at = rest_.find('\n');
        while (at != std::string_view::npos && endsInBackslash(rest_.substr(0, at)))
            at = rest_.find('\n', at + 1);
        return orAll(at, 0);
    }

    static bool endsInBackslash(std::string_view line) {
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line.ends_with('\\');
    }

    std::size_t blockComment() {
        piece_ = Piece::comment;
        return orAll(rest_.find("*/", 2), 2);
    }

    std::size_t quoted(char quote) {
        piece_ = Piece::literal;
        for (std::size_t i = 1; i < rest_.size(); ++i) {
            if (rest_[i] == '\\')
                ++i;
            else if (rest_[i] == quote)
                return i + 1;
            else if (rest_[i] == '\n')
                return i;  // unterminated: ends with its line here; the compiler reports it
        }
        return rest_.size();
    }

    // True inside a number: a digit separator as in 1'000 starts no literal. `word_` then holds the
    // digits since the last separator.
    [[nodiscard]] bool isInNumber() const {
        return !word_.empty() && std::isxdigit(static_cast<unsigned char>(word_.back())) != 0 &&
               word_ != "u8";
    }

    // Raw string literal R"(...)", also with an encoding prefix: u8R, uR, UR, LR.
    [[nodiscard]] bool isRawPrefix() const {
        std::string_view word = word_;
        if (!word.ends_with('R')) return false;
        word.remove_suffix(1);
        return word.empty() || word == "u8" || word == "u" || word == "U" || word == "L";
    }

    std::size_t rawString() {
        const std::size_t open = rest_.find('(');
        constexpr std::size_t kLongestDelimiter = 16;
        if (open == std::string_view::npos || open > kLongestDelimiter + 1) return quoted('"');
        piece_ = Piece::literal;
        std::string end{')'};
        end.append(rest_.substr(1, open - 1)).push_back('"');
        return orAll(rest_.find(end, open), end.size());
    }

    // Keeps the word that ends before the next piece: a literal's prefix, or a number.
    void remember() {
        if (piece_ == Piece::character && !text_.empty() && isWordCharacter(text_.front()))
            word_ += text_.front();
        else
            word_.clear();
    }

    std::string_view rest_;
    std::string_view text_;
    std::string word_;
    Piece piece_ = Piece::character;
};

}  // namespace

std::optional<std::string> taskText(std::string_view source, std::string_view task) {
    const std::string begin = "TASK " + std::string{task} + " begin";
    const std::string end = "TASK " + std::string{task} + " end";
    std::optional<std::string> text;
    for (Lexer lexer{source}; lexer.next();) {
        if (lexer.piece() == Lexer::Piece::comment) {
            const std::string_view comment = trimmed(lexer.text().substr(2));
            if (comment == begin && !text) text.emplace();
            if (comment == end && text) return text;
            continue;
        }
        if (text && (lexer.piece() == Lexer::Piece::literal || !isSpace(lexer.text().front())))
            *text += lexer.text();
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
    for (Lexer lexer{source}; lexer.next();) {
        const std::string_view text = lexer.text();
        const bool isBlank = lexer.piece() == Lexer::Piece::comment
                                 ? !text.starts_with("/*") || isClosedComment(text)
                                 : text.size() == 1 && isSpace(text.front());
        if (!isBlank) return true;
    }
    return false;
}

}  // namespace ticker::intake
