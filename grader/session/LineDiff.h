#ifndef TICKER_SESSION_LINEDIFF_H
#define TICKER_SESSION_LINEDIFF_H

#include <string_view>
#include <vector>

namespace ticker::session {

/// One line of a difference between two texts.
struct DiffLine {
    char kind = ' ';        ///< ' ' in both, '-' in the first only, '+' in the second only
    std::string_view text;  ///< into the text that has it

    bool operator==(const DiffLine&) const = default;
};

/// The shortest list of removed and added lines that turns one text into the other, in order. If
/// one of the texts has more than 2000 lines between the equal lines at the beginning and at the
/// end, all lines in between are removed and added.
[[nodiscard]] std::vector<DiffLine> lineDiff(std::string_view before, std::string_view after);

}  // namespace ticker::session

#endif
