#ifndef TICKER_TASKS_DRAWINGS_LETTEREDGES_H
#define TICKER_TASKS_DRAWINGS_LETTEREDGES_H

#include <vector>

namespace ticker::tasks::drawings {

/// A place on the map of letters, in texels: x from its left, y from its top.
struct MapPlace {
    double x = 0.0;
    double y = 0.0;
};

/// A straight edge of a letter, across which the map rises or falls.
struct LetterEdge {
    MapPlace from;
    MapPlace to;
    bool isUpright = false;  ///< the edge runs along a column, and its slope along u
    double rise = 0.0;       ///< 1: the map rises to the right or downwards; -1: it falls

    /// The place at a share of its length, 0 to 1.
    [[nodiscard]] MapPlace at(double share) const;
    [[nodiscard]] double length() const;  ///< texels
};

/// All edges of the letter in a cell of `bump::letterMap`.
/// @param column  Of the cell, 0 to 7.
/// @param row     Of the cell: 0 or 1.
[[nodiscard]] std::vector<LetterEdge> edgesOf(int column, int row);

inline constexpr int kCellColumns = 8;
inline constexpr int kCellRows = 2;
/// The middle of a cell.
[[nodiscard]] MapPlace centreOf(int column, int row);

}  // namespace ticker::tasks::drawings

#endif
