#ifndef TICKER_TASKS_BUMP_POISSON_H
#define TICKER_TASKS_BUMP_POISSON_H

#include <vector>

namespace ticker::tasks::bump {

/// Differences between neighbours of a grid: `right[i]` from cell i to the next column, `down[i]`
/// from cell i to the next row. The last column of `right` and the last row of `down` are not used.
struct GridDifferences {
    int columns = 0;
    int rows = 0;
    std::vector<double> right;
    std::vector<double> down;
};

/// The heights whose differences fit these best in least squares; their mean is 0. Exact: the
/// normal equations are a Poisson equation with free edges, solved by cosine transforms (T.
/// Simchony, R. Chellappa, M. Shao, "Direct Analytical Methods for Solving Poisson Equations in
/// Computer Vision Problems", PAMI 1990).
[[nodiscard]] std::vector<double> integrate(const GridDifferences& differences);

}  // namespace ticker::tasks::bump

#endif
