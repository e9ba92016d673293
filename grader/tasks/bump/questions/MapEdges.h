#ifndef TICKER_TASKS_BUMP_MAPEDGES_H
#define TICKER_TASKS_BUMP_MAPEDGES_H

#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <cstddef>
#include <vector>

namespace ticker::tasks::bump {

/// Two maps of one gentle wave at a great height, which close without a step: the last column goes
/// on in the first one, and so does the last row. What a code reads beyond the edge (the other end,
/// the last texel again, the one before it) hardly matters; a height that the map does not have
/// makes a wall.
struct EdgePlan {
    std::vector<Vector3> directions;
    std::size_t flat = 0;  ///< of height 0: chords of a displaced surface lean even there
    std::size_t columnWaves = 0;
    std::size_t rowWaves = 0;
};

[[nodiscard]] EdgePlan planEdges(Questionnaire& questionnaire, Draws& draws, const Ball& ball);

/// How many times as far the normal tilts at the map's edge as anywhere else: 1 where all is well.
struct MapEdges {
    double seam = 1.0;     ///< first and last columns
    double endRows = 1.0;  ///< first and last rows

    // The texels beside a neighbour are three slopes away at most; the middle of the map is 17, a
    // height of 0 is 110, or 18 for a difference over six texels.
    static constexpr double kMost = 6.0;
    [[nodiscard]] bool goodSeam() const { return seam <= kMost; }
    [[nodiscard]] bool goodEndRows() const { return endRows <= kMost; }
};

[[nodiscard]] MapEdges readEdges(const EdgePlan& plan, const Answers& answers,
                                 const Parametrisation& parametrisation);

}  // namespace ticker::tasks::bump

#endif
