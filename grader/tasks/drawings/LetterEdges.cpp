#include <grader/tasks/drawings/LetterEdges.h>

#include <grader/tasks/bump/questions/LetterMap.h>

#include <cmath>

namespace ticker::tasks::drawings {
namespace {

constexpr int kCell = bump::kLetterMapWidth / kCellColumns;  // texels
constexpr int kTop = (bump::kLetterMapHeight - kCellRows * kCell) / 2;

/// 1 for a raised texel and -1 for a lowered one, if it has at least half of the letter's height; 0
/// otherwise.
double solid(int column, int row) {
    const double height = bump::letterHeight(column, row);
    return std::abs(height) >= 0.5 ? (height > 0.0 ? 1.0 : -1.0) : 0.0;
}

/// Adds the edges that lie on one line between texels.
/// @param isUpright  Whether the line runs along a column or along a row.
/// @param line       Column to the right of the line, or row below it.
/// @param begin      First texel along the line; `kCell` of them are searched.
void addEdges(std::vector<LetterEdge>& edges, bool isUpright, int line, int begin) {
    const auto riseAt = [&](int along) {
        return isUpright ? solid(line, along) - solid(line - 1, along)
                         : solid(along, line) - solid(along, line - 1);
    };
    const auto place = [&](int along) {
        return isUpright ? MapPlace{1.0 * line, 1.0 * along} : MapPlace{1.0 * along, 1.0 * line};
    };
    for (int at = begin; at < begin + kCell; ++at) {
        const double rise = riseAt(at);
        if (rise == 0.0) continue;
        const int start = at;
        while (at < begin + kCell && riseAt(at) == rise)
            ++at;
        edges.push_back({place(start), place(at), isUpright, rise});
    }
}

}  // namespace

MapPlace LetterEdge::at(double share) const {
    return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
}

double LetterEdge::length() const {
    return std::hypot(to.x - from.x, to.y - from.y);
}

std::vector<LetterEdge> edgesOf(int column, int row) {
    const int left = column * kCell;
    const int top = kTop + row * kCell;
    std::vector<LetterEdge> edges;
    for (int line = 1; line < kCell; ++line) {
        addEdges(edges, true, left + line, top);
        addEdges(edges, false, top + line, left);
    }
    return edges;
}

MapPlace centreOf(int column, int row) {
    return {(column + 0.5) * kCell, kTop + (row + 0.5) * kCell};
}

}  // namespace ticker::tasks::drawings
