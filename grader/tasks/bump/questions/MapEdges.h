#ifndef TICKER_TASKS_BUMP_MAPEDGES_H
#define TICKER_TASKS_BUMP_MAPEDGES_H

#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <cstddef>
#include <vector>

namespace ticker::tasks::bump {

/// Two maps of one gentle wave at a great height. Both are periodic: the last column continues in
/// the first one, and the last row in the first. A neighbour beyond the edge may be the other end,
/// the last texel again or the one before it, which hardly matters here; a height from outside the
/// map makes a wall.
struct EdgePlan {
    std::vector<Vector3> directions;
    std::size_t flat = 0;  ///< height 0: normals of chords lean even there
    std::size_t columnWaves = 0;
    std::size_t rowWaves = 0;
};

[[nodiscard]] EdgePlan planEdges(Questionnaire& questionnaire, Draws& draws, const Ball& ball);

/// Tilt at the map's edge divided by the tilt elsewhere; 1 is right.
struct MapEdges {
    double seam = 1.0;     ///< first and last columns
    double endRows = 1.0;  ///< first and last rows

    // Accepted neighbours at the edge give at most three slopes. A neighbour as high as the map's
    // middle would give 20, one of height 0 would give 130, or 21 with a difference over six
    // texels.
    static constexpr double kMost = 6.0;
    [[nodiscard]] bool goodSeam() const { return seam <= kMost; }
    [[nodiscard]] bool goodEndRows() const { return endRows <= kMost; }
};

[[nodiscard]] MapEdges readEdges(const EdgePlan& plan, const Answers& answers,
                                 const Parametrisation& parametrisation);

}  // namespace ticker::tasks::bump

#endif
