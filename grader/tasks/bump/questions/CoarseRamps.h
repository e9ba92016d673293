#ifndef TICKER_TASKS_BUMP_COARSERAMPS_H
#define TICKER_TASKS_BUMP_COARSERAMPS_H

#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Ramps.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <vector>

namespace ticker::tasks::bump {

/// Ramps and bows with heights in whole bytes, as in pictures. They serve code that rounds heights
/// to bytes: it is right on every picture, but not on ramps with fractional heights. Slopes are
/// whole bytes, too, so that a bow's slopes are right on average only: several points are asked for
/// beside each place.
struct CoarsePlan {
    Questionnaire questionnaire;
    std::vector<Vector3> places;
    RampPlan ramps;  ///< at `kPointsPerPlace` points for each place
};

[[nodiscard]] CoarsePlan planCoarse(Draws& draws, const Ball& ball);

/// Mean tilts at each place. Points at the step from 255 to 0 are left out.
[[nodiscard]] std::vector<RampTilts> readCoarse(const CoarsePlan& plan, const Answers& answers);

}  // namespace ticker::tasks::bump

#endif
