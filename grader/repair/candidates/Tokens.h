#ifndef TICKER_REPAIR_CANDIDATES_TOKENS_H
#define TICKER_REPAIR_CANDIDATES_TOKENS_H

#include <compare>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::candidates {

/// A range of a text, in bytes.
struct Range {
    std::size_t begin = 0;
    std::size_t end = 0;

    [[nodiscard]] std::size_t size() const { return end - begin; }
    [[nodiscard]] bool holds(const Range& other) const {
        return begin <= other.begin && other.end <= end;
    }
    // NOLINTNEXTLINE(modernize-use-nullptr): the compiler's own comparison with 0
    [[nodiscard]] auto operator<=>(const Range&) const = default;
};

/// The words and signs of a C++ text, without white space and comments.
[[nodiscard]] std::vector<Range> tokensOf(std::string_view text);

/// The same as texts.
[[nodiscard]] std::vector<std::string_view> wordsOf(std::string_view text);

/// A text and its tokens.
class Source {
public:
    explicit Source(std::string text) : text_(std::move(text)), tokens_(tokensOf(text_)) {}

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] std::string_view in(const Range& range) const {
        return std::string_view{text_}.substr(range.begin, range.size());
    }
    /// The tokens that lie in a range.
    [[nodiscard]] std::vector<Range> tokensIn(const Range& range) const;
    /// 1 for the first line.
    [[nodiscard]] std::size_t lineOf(std::size_t offset) const;

private:
    std::string text_;
    std::vector<Range> tokens_;
};

}  // namespace ticker::candidates

#endif
