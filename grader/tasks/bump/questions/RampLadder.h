#ifndef TICKER_TASKS_BUMP_RAMPLADDER_H
#define TICKER_TASKS_BUMP_RAMPLADDER_H

#include <grader/tasks/bump/answers/RampJudgement.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Ramps.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <vector>

namespace ticker::tasks::bump {

/// Ramps of three steepnesses on one sphere.
struct RampLadder {
    RampPlan gentle;    ///< a rise of 0.1, at any grey: tilts are proportional to slopes
    RampPlan moderate;  ///< heights of 0 to 1: ten times that, used if gentle ramps tilt little
    RampPlan steep;     ///< heights of 0 to 5, as in real maps
};

/// @param directions  Points to ask for; the steep ramps use the first half of them.
[[nodiscard]] RampLadder planLadder(Questionnaire& questionnaire, Draws& draws, const Ball& ball,
                                    const std::vector<Vector3>& directions);

/// Ramps of random sides, so that a submission cannot expect their size.
[[nodiscard]] RampShape drawShape(Draws& draws, double rise);

struct LadderJudgement {
    RampJudgement ramps;         ///< on the gentlest ramps that tilt clearly
    double flatTilt = 0.0;       ///< largest median tilt on maps without slope
    double sharedNormals = 0.0;  ///< share of such maps' points that have another point's normal
    bool growsWithSlope = true;  ///< 50 times the slope tilts at least twice as much
    double steepAgrees = 1.0;    ///< share of the points at which a ramp from black to white tilts
                                 ///< in the same direction as a gentle one
};

[[nodiscard]] LadderJudgement judgeLadder(const RampLadder& ladder, const Answers& answers);

}  // namespace ticker::tasks::bump

#endif
