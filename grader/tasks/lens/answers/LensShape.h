#ifndef TICKER_TASKS_LENS_ANSWERS_LENSSHAPE_H
#define TICKER_TASKS_LENS_ANSWERS_LENSSHAPE_H

#include <grader/tasks/lens/answers/LensLog.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ticker::tasks {

/// The lens points of all pixels.
struct Lens {
    std::vector<Vector3> points;
    std::size_t distinct = 0;  ///< number of points that count as independent
    Vector3 low;
    Vector3 high;

    [[nodiscard]] Vector3 centre() const { return (low + high) * 0.5; }
    /// Half of the wider side.
    [[nodiscard]] double halfWidth() const {
        return 0.5 * std::max(high.x - low.x, high.y - low.y);
    }
};

[[nodiscard]] Lens lensOf(const LensLog& log);

/// The few places, at equal steps, that the lens points have along one axis: the columns or the
/// rows of a grid.
struct Columns {
    std::size_t count = 0;  ///< 0: the points are no grid along this axis
    double step = 0.0;
    double mean = 0.0;  ///< of the places

    /// How far the grid is off the eye, in steps: a half if the points are the edges of the cells.
    [[nodiscard]] double aside() const { return count == 0 ? 0.0 : mean / step; }
};

/// Finds the columns or rows of a grid in the lens points of all pixels.
/// @param axis  `&Vector3::x` for columns, `&Vector3::y` for rows.
/// @return      A count of 0 if the places are fewer than 3, too many for a square grid, or at
///              unequal steps. Likewise if the numbers of rays of two places differ by more than
///              one for each pixel: a grid that is cut short.
[[nodiscard]] Columns columnsOf(const LensLog& log, double Vector3::*axis);

/// Confidence bound on how much narrower than the aperture `count` independent points are, as a
/// share of its width. The range of n uniform points in [0, 1] has P(range <= r) = n r^(n-1) -
/// (n-1) r^n; bisection finds the r whose chance is `kStatementRisk`. 1 for fewer than 3 points.
[[nodiscard]] double rangeShortfall(std::size_t count);

/// Test of the corners: a share of 1 - pi/4 of a square's points lies outside of the inscribed
/// disc, and none of a disc's. The marginals and the two diagonals test for an uneven density.
struct ShapeVerdict {
    bool square = true;
    double cornerShare = 0.0;
    double gap = 0.0;
};

[[nodiscard]] ShapeVerdict judgeShape(const Lens& lens);

}  // namespace ticker::tasks

#endif
