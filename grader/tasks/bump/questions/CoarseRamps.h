#ifndef TICKER_TASKS_BUMP_COARSERAMPS_H
#define TICKER_TASKS_BUMP_COARSERAMPS_H

#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Ramps.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <vector>

namespace ticker::tasks::bump {

/// Ramps and bows whose heights are whole bytes, as a picture's are: for code that rounds heights
/// to bytes, which no picture shows and every ramp of fractions does. Slopes are whole bytes, too,
/// so that a bow's are right on average only: each place is asked for at several points beside it.
struct CoarsePlan {
    Questionnaire questionnaire;
    std::vector<Vector3> places;
    RampPlan ramps;  ///< at `kPointsPerPlace` points for each place
};

[[nodiscard]] CoarsePlan planCoarse(Draws& draws, const Ball& ball);

/// The mean tilts at each place. Steps at which bytes begin anew are left out.
[[nodiscard]] std::vector<RampTilts> readCoarse(const CoarsePlan& plan, const Answers& answers);

}  // namespace ticker::tasks::bump

#endif
