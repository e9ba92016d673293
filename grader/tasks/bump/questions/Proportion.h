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

/// How many times as far the steep slopes tilt the normal: the median over the points. `kTimes`
/// where the gentle ones tilt hardly a point, which is for others to say.
struct Proportion {
    double growth = ProportionPlan::kTimes;

    /// Accepted readings have 23.1 to 25.1 (heights through another curve, displaced surfaces).
    /// Slopes cut off at 0.4 or lower, or their roots, stay below.
    [[nodiscard]] bool good() const { return growth >= 0.4 * ProportionPlan::kTimes; }
};

[[nodiscard]] Proportion readProportion(const ProportionPlan& plan, const Answers& answers);

}  // namespace ticker::tasks::bump

#endif
