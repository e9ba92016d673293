#ifndef TICKER_LAB_SIMILAR_TOKENTEXT_H
#define TICKER_LAB_SIMILAR_TOKENTEXT_H

#include <string>
#include <string_view>
#include <vector>

namespace ticker::similar {

/// A piece of C++ text.
struct Token {
    enum class Kind { space, comment, directive, word, number, text, mark };
    Kind kind = Kind::mark;
    std::string text;
};

/// The pieces of a C++ text, in order; together they are the text. Raw strings are not recognised.
[[nodiscard]] std::vector<Token> tokensOf(std::string_view source);
[[nodiscard]] std::string sourceOf(const std::vector<Token>& tokens);

}  // namespace ticker::similar

#endif
