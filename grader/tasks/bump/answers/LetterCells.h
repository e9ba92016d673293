#ifndef TICKER_TASKS_BUMP_ANSWERS_LETTERCELLS_H
#define TICKER_TASKS_BUMP_ANSWERS_LETTERCELLS_H

#include <grader/tasks/bump/answers/Letters.h>
#include <grader/tasks/bump/questions/LetterMap.h>

#include <vector>

namespace ticker::tasks::bump {

/// One point of the grid: its place on the map, the map's height and slopes, the recovered slopes.
struct Cell {
    double column = 0.0;  // texels, not rounded
    double row = 0.0;
    double height = 0.0;  // -1 to 1
    Letter kind = Letter::none;
    double trueU = 0.0;  // height per texel
    double trueV = 0.0;
    double seenU = 0.0;  // likewise, from the tilt
    double seenV = 0.0;
};

using CellGrid = std::vector<Cell>;

/// The grid of the letters' question with the slopes that the answers show, scaled to the true
/// ones.
[[nodiscard]] CellGrid recover(const LetterPlan& plan, const Answers& answers,
                               const Parametrisation& parametrisation, const Response& response);

}  // namespace ticker::tasks::bump

#endif
