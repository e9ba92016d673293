#ifndef TICKER_TASKS_BUMP_PLACES_EVENSTEPS_H
#define TICKER_TASKS_BUMP_PLACES_EVENSTEPS_H

#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <vector>

namespace ticker::tasks::bump {

/// Columns that rise from black to white by one grey level each, and fall back to black.
struct EvenStepPlan {
    std::vector<Vector3> directions;  ///< round the equator, in the order of their longitudes
    LevelPair ramp;
};

[[nodiscard]] EvenStepPlan planEvenSteps(Questionnaire& questionnaire, Draws& draws,
                                         const Ball& ball);

/// Share of the columns whose tilt along u differs from that of the columns around. It is measured
/// at several places within the columns, and the smallest share counts. The slope is the same
/// everywhere but at black and at white, whatever the reading. Heights that are cut to whole grey
/// levels lose one now and then: the step before is then 0, and the one after twice as high.
struct EvenSteps {
    double uneven = 0.0;

    /// Differences over six texels are uneven at black and at white, a fortieth of the columns.
    [[nodiscard]] bool good() const { return uneven <= 0.05; }
};

/// @return  0 if the map's poles do not lie above and below.
[[nodiscard]] EvenSteps readEvenSteps(const EvenStepPlan& plan, const Answers& answers,
                                      const Parametrisation& parametrisation);

}  // namespace ticker::tasks::bump

#endif
