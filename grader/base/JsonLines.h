#ifndef TICKER_BASE_JSONLINES_H
#define TICKER_BASE_JSONLINES_H

#include <cstddef>
#include <string>
#include <string_view>

namespace ticker {

/// The line, from 1, of a place in a JSON text.
/// @param text   Need not be valid JSON to its end.
/// @param place  "/options/0/name": member names and numbers of array items, each after a slash, as
///               they are; empty: the whole text.
/// @return 0 if the text has no such place.
[[nodiscard]] int jsonLineOf(const std::string& text, std::string_view place);

/// The line, counted from 1, that holds a byte.
/// @param byte  Counted from 1, as parsers report where they stopped.
[[nodiscard]] int lineOfByte(std::string_view text, std::size_t byte);

}  // namespace ticker

#endif
