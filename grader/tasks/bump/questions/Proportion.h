#ifndef TICKER_TASKS_BUMP_PROPORTION_H
#define TICKER_TASKS_BUMP_PROPORTION_H

#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <cstddef>
#include <vector>

namespace ticker::tasks::bump {

/// The same random texels twice, with gentle slopes and with slopes as steep as real maps have
/// them. Whatever difference, interpolation or smoothing a code takes, all slopes of the second map
/// are `kTimes` those of the first, at every point.
struct ProportionPlan {
    static constexpr int kTimes = 24;

    std::vector<Vector3> directions;
    std::size_t flat = 0;
    std::size_t gentle = 0;  ///< 0.04 heights for each texel, on average
    std::size_t steep = 0;   ///< 0.9
};

[[nodiscard]] ProportionPlan planProportion(Questionnaire& questionnaire, Draws& draws,
                                            const Ball& ball);

/// What the steep slopes do beside the gentle ones.
struct Proportion {
    /// How many times as far they tilt the normal: the median over the points. `kTimes` where the
    /// gentle ones tilt hardly a point, which is for others to say.
    double growth = ProportionPlan::kTimes;
    /// Share of the points whose normal leans 90 degrees or more on the steep slopes.
    double pastHorizon = 0.0;

    /// Accepted readings have 23.1 to 25.1 (heights through another curve, displaced surfaces).
    /// Slopes cut off at 0.4 or lower, or their roots, stay below.
    [[nodiscard]] bool good() const { return growth >= 0.4 * ProportionPlan::kTimes; }
    /// A slope leaves n in the sum whole, so that no tilt reaches the horizon. Tangents of a
    /// texel's corner, and chords, take very strong tilts beyond it at few points, next to the
    /// poles.
    [[nodiscard]] bool staysAboveHorizon() const { return pastHorizon < 0.03; }
};

[[nodiscard]] Proportion readProportion(const ProportionPlan& plan, const Answers& answers);

}  // namespace ticker::tasks::bump

#endif
