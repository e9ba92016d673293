#ifndef TICKER_INTAKE_SOURCEPIECE_H
#define TICKER_INTAKE_SOURCEPIECE_H

#include <cstddef>
#include <string_view>

namespace ticker::intake {

/// A comment, a string or character literal, a number or another single character of C++ source.
struct Piece {
    enum class Kind { comment, literal, rawString, number, character };
    Kind kind = Kind::character;
    std::string_view text;  ///< of a literal without its prefix (u8, L, R)
};

/// The piece of a source that begins at a place before its end, where the piece before it ends.
[[nodiscard]] Piece pieceAt(std::size_t at, std::string_view source);

/// The raw string at the beginning of a text. @param rest  From the quote after the R.
[[nodiscard]] std::string_view rawString(std::string_view rest);

}  // namespace ticker::intake

#endif
