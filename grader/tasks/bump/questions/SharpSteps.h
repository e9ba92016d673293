#ifndef TICKER_TASKS_BUMP_SHARPSTEPS_H
#define TICKER_TASKS_BUMP_SHARPSTEPS_H

#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

namespace ticker::tasks::bump {

/// Range of the heights of blocks, in bytes.
struct StepHeights {
    int least = 0;
    int most = 0;
};
/// A signed byte (at most 127) holds none of these.
inline constexpr StepHeights kWhiteSteps{200, 240};
/// Heights of more than 2.3 and less than 3.8: fixed-point differences that wrap at 2 turn the sign
/// of these steps, and not of steps above 4.
inline constexpr StepHeights kLightSteps{120, 190};

/// One pattern of blocks twice, at the same points: grey on black, and higher ones.
struct SharpStepPlan {
    LevelPair grey;    ///< steps of 100 bytes
    LevelPair higher;  ///< of the heights that were asked for
    bool isWhite = true;
};

/// @param heights  The range that the height of the second pattern is drawn from.
[[nodiscard]] SharpStepPlan planSharpSteps(Questionnaire& questionnaire, Draws& draws,
                                           const Ball& ball,
                                           const StepHeights& heights = kWhiteSteps);

/// Share of the points that both patterns tilt, but to opposite sides. Whatever the reading, a
/// higher step tilts to the same side; rounding decides at none of these points. Differences that
/// are kept in a number that is too short for them wrap, and turn all of them.
struct SharpSteps {
    double turned = 0.0;
    bool isWhite = true;  ///< whether the higher steps are `kWhiteSteps`

    [[nodiscard]] bool good() const { return turned <= 0.1; }
};

/// Whether a smaller share of the points turns.
[[nodiscard]] inline bool turnsFewer(const SharpSteps& some, const SharpSteps& others) {
    return some.turned < others.turned;
}

[[nodiscard]] SharpSteps readSharpSteps(const SharpStepPlan& plan, const Answers& answers);

}  // namespace ticker::tasks::bump

#endif
