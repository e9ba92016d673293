#ifndef TICKER_CALIBRATE_CODEONLY_H
#define TICKER_CALIBRATE_CODEONLY_H

#include <string>
#include <string_view>

namespace ticker::calibrate {

/// A C++ source without what cannot change a verdict: comments, white space, and the words of
/// messages. Strings that stand beside each other count as one; one with a blank is a message, and
/// its text is left out. A finding's id has none, so that it stays.
[[nodiscard]] std::string codeOnly(std::string_view source);

}  // namespace ticker::calibrate

#endif
