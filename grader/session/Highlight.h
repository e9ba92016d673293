#ifndef TICKER_SESSION_HIGHLIGHT_H
#define TICKER_SESSION_HIGHLIGHT_H

#include <string>
#include <string_view>

namespace ticker::session {

/// C++ source as HTML, one `<span class="line">` for each line; within it `<i class="...">` around
/// keywords (k), numbers (n), strings (s), comments (c), preprocessor lines (p) and the kit's task
/// marks (m). Everything is escaped; the source may be any bytes.
[[nodiscard]] std::string highlightCpp(std::string_view source);

}  // namespace ticker::session

#endif
