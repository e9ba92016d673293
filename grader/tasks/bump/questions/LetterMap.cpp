#include <grader/tasks/bump/questions/LetterMap.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ticker::tasks::bump {
namespace {

constexpr int kCell = 80;
constexpr int kTopRow = 80;
constexpr double kEdge = 6.0;  // texels from the ground to the full height
constexpr double kGround = 128.0;

/// A stroke, in texels of its cell.
struct Stroke {
    double left;
    double right;
    double top;
    double bottom;

    /// Coverage at (x, y): 0 outside, 1 inside, an even slope at the edge.
    [[nodiscard]] double coverage(double x, double y) const {
        const double depth = std::min({x - left, right - x, y - top, bottom - y});
        return std::clamp(0.5 + depth / kEdge, 0.0, 1.0);
    }
};

constexpr std::array<Stroke, 3> kH{{{14, 29, 10, 70}, {51, 66, 10, 70}, {20, 60, 32, 48}}};
constexpr std::array<Stroke, 2> kL{{{18, 33, 10, 70}, {18, 62, 55, 70}}};

template <std::size_t N>
double coverage(const std::array<Stroke, N>& strokes, double x, double y) {
    double most = 0.0;
    for (const Stroke& stroke : strokes)
        most = std::max(most, stroke.coverage(x, y));
    return most;
}

}  // namespace

Letter letterAt(int column, int row) {
    if (row < kTopRow || row >= kTopRow + 2 * kCell) return Letter::none;
    return (column / kCell + (row - kTopRow) / kCell) % 2 == 0 ? Letter::h : Letter::l;
}

double letterHeight(int column, int row) {
    const double x = column % kCell + 0.5;
    const double y = (row - kTopRow) % kCell + 0.5;
    switch (letterAt(column, row)) {
        case Letter::h:
            return coverage(kH, x, y);
        case Letter::l:
            return -coverage(kL, x, y);
        case Letter::none:
            break;
    }
    return 0.0;
}

probe::HeightMapDescription letterMap() {
    probe::HeightMapDescription map{kLetterMapWidth, kLetterMapHeight, {}, {}, {}};
    map.bytes.reserve(static_cast<std::size_t>(kLetterMapWidth) * kLetterMapHeight);
    for (int row = 0; row < kLetterMapHeight; ++row)
        for (int column = 0; column < kLetterMapWidth; ++column)
            map.bytes.push_back(static_cast<std::uint8_t>(
                std::lround(kGround + kLetterLift * letterHeight(column, row))));
    return map;
}

}  // namespace ticker::tasks::bump
