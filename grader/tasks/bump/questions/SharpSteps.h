#ifndef TICKER_TASKS_BUMP_SHARPSTEPS_H
#define TICKER_TASKS_BUMP_SHARPSTEPS_H

#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

namespace ticker::tasks::bump {

/// One pattern of blocks twice, at the same points: grey on black, and nearly white on black.
struct SharpStepPlan {
    LevelPair grey;   ///< steps of 100 bytes
    LevelPair white;  ///< of 200 to 240
};

[[nodiscard]] SharpStepPlan planSharpSteps(Questionnaire& questionnaire, Draws& draws,
                                           const Ball& ball);

/// Share of the points that both patterns tilt, but to opposite sides. Whatever the reading, a
/// higher step tilts to the same side; rounding decides at none of these points. Differences that
/// are kept in a signed byte wrap, and turn all of them.
struct SharpSteps {
    double turned = 0.0;

    [[nodiscard]] bool good() const { return turned <= 0.1; }
};

[[nodiscard]] SharpSteps readSharpSteps(const SharpStepPlan& plan, const Answers& answers);

}  // namespace ticker::tasks::bump

#endif
