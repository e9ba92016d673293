#include <grader/lab/calibrate/CodeOnly.h>

#include <cctype>
#include <cstddef>
#include <optional>

namespace ticker::calibrate {
namespace {

bool isWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool isBlank(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// Reads a source from its beginning to its end.
class Reduction {
public:
    explicit Reduction(std::string_view source) : source_(source) {}

    [[nodiscard]] std::string run() {
        while (at_ < source_.size()) {
            if (skipGap()) continue;
            if (const std::optional<std::string> text = literal())
                addLiteral(*text);
            else if (isQuoted())
                addQuoted();
            else
                add(source_[at_++]);
        }
        flush();
        return code_;
    }

private:
    [[nodiscard]] bool startsWith(std::string_view what) const {
        return source_.substr(at_, what.size()) == what;
    }
    void moveBehind(std::string_view what, std::size_t from) {
        const std::size_t found = source_.find(what, from);
        at_ = found == std::string_view::npos ? source_.size() : found + what.size();
    }

    // Skips a comment or white space; false if neither begins here. The line break that ends a
    // preprocessor directive belongs to the code.
    bool skipGap() {
        if (startsWith("//")) {
            const std::size_t end = source_.find('\n', at_);
            at_ = end == std::string_view::npos ? source_.size() : end;
        } else if (startsWith("/*")) {
            moveBehind("*/", at_ + 2);
        } else if (isBlank(source_[at_])) {
            if (source_[at_] == '\n' && isDirective_) {
                flush();
                code_ += '\n';
                isDirective_ = false;
            }
            ++at_;
        } else {
            return false;
        }
        isGap_ = true;
        return true;
    }

    // The text of a string that begins here.
    std::optional<std::string> literal() {
        if (startsWith("R\"") && (at_ == 0 || !isWord(source_[at_ - 1]))) return rawLiteral();
        if (source_[at_] != '"') return std::nullopt;
        const std::size_t begin = ++at_;
        while (at_ < source_.size() && source_[at_] != '"')
            at_ += source_[at_] == '\\' ? 2 : 1;
        const std::string_view text = source_.substr(begin, at_ - begin);
        ++at_;
        return std::string{text};
    }
    std::string rawLiteral() {
        const std::size_t open = source_.find('(', at_);
        const std::string close = ")" + std::string{source_.substr(at_ + 2, open - at_ - 2)} + "\"";
        const std::size_t end = source_.find(close, open);
        moveBehind(close, open);
        return std::string{source_.substr(open + 1, end - open - 1)};
    }

    // True for the apostrophe of a character literal; false for one between the digits of a number.
    [[nodiscard]] bool isQuoted() const {
        return source_[at_] == '\'' && (at_ == 0 || !isWord(source_[at_ - 1]));
    }
    void addQuoted() {
        add(source_[at_++]);
        while (at_ < source_.size() && source_[at_] != '\'') {
            if (source_[at_] == '\\') code_ += source_[at_++];
            if (at_ < source_.size()) code_ += source_[at_++];
        }
        if (at_ < source_.size()) code_ += source_[at_++];
    }

    void add(char c) {
        flush();
        if (c == '#' && (code_.empty() || code_.back() == '\n' || isGap_)) isDirective_ = true;
        if (isGap_ && isWord(c) && !code_.empty() && isWord(code_.back())) code_ += ' ';
        code_ += c;
        isGap_ = false;
    }
    void addLiteral(const std::string& text) {
        pending_ = pending_.value_or("") + text;
        isGap_ = false;
    }
    // Writes the pending string, to which no further literal was added; one with a blank as "".
    void flush() {
        if (!pending_) return;
        if (pending_->find_first_of(" \n") != std::string::npos) pending_->clear();
        code_ += '"' + *pending_ + '"';
        pending_.reset();
    }

    std::string_view source_;
    std::size_t at_ = 0;
    std::string code_;
    std::optional<std::string> pending_;
    bool isGap_ = false;
    bool isDirective_ = false;
};

}  // namespace

std::string codeOnly(std::string_view source) {
    return Reduction{source}.run();
}

}  // namespace ticker::calibrate
