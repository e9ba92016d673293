#ifndef TICKER_TASKS_BUMP_PROPORTION_H
#define TICKER_TASKS_BUMP_PROPORTION_H

#include <grader/tasks/bump/answers/RampJudgement.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ticker::tasks::bump {

/// The same random texels, with gentle slopes and with slopes as steep as in real maps. All slopes
/// of the steep map are `kTimes` those of the gentle one at every point, under any difference,
/// interpolation or smoothing. The gentle ones are asked for again near black and near white.
struct ProportionPlan {
    static constexpr int kTimes = 24;

    std::vector<Vector3> directions;
    std::size_t flat = 0;
    std::size_t gentle = 0;  ///< slopes of 0.04 heights for each texel, on average
    std::size_t steep = 0;   ///< 0.9
    std::size_t dark = 0;    ///< the gentle map at heights of 0 to 0.14
    std::size_t bright = 0;  ///< likewise from 4.6 to 4.9
};

[[nodiscard]] ProportionPlan planProportion(Questionnaire& questionnaire, Draws& draws,
                                            const Ball& ball);

/// The tilts on steep slopes compared with those on gentle slopes.
struct Proportion {
    /// Ratio of the tilts, steep to gentle: the median over the points. `kTimes` if gentle slopes
    /// tilt hardly any point, which other checks report.
    double growth = ProportionPlan::kTimes;
    /// Share of the points whose normal leans 90 degrees or more on the steep slopes.
    double pastHorizon = 0.0;
    /// Length of the tilts on gentle slopes where the map is bright over that where it is dark: the
    /// ratio of the medians.
    double brightOverDark = 1.0;
    /// Likewise for the gentle map at heights between both.
    double middleOverDark = 1.0;

    /// Accepted readings give 23.1 to 25.1 (displaced surfaces).
    /// Slopes cut off at 0.4 or lower, and roots of slopes, stay below the limit.
    [[nodiscard]] bool good() const { return growth >= 0.4 * ProportionPlan::kTimes; }
    /// The sum always contains the whole n, so that no tilt reaches the horizon. Tangents at a
    /// texel's corner, and chords, exceed it with very strong tilts at few points next to the
    /// poles.
    [[nodiscard]] bool staysAboveHorizon() const { return pastHorizon < 0.03; }
    /// A slope counts alike at every height. The displaced surface 1 + h of a unit sphere is the
    /// weakest where the map is bright, by 1 / 5.9; a root by 1 / 7 or less, a square gives 50. A
    /// curve that is steeper, or flatter, in the middle than at both ends (an S) leaves the range
    /// between both.
    [[nodiscard]] bool isSameAtEveryHeight() const {
        constexpr double kBeyond = 1.4;
        return brightOverDark <= 2.5 && brightOverDark >= 1.0 / 6.2 &&
               middleOverDark <= kBeyond * std::max(1.0, brightOverDark) &&
               middleOverDark * kBeyond >= std::min(1.0, brightOverDark);
    }
};

[[nodiscard]] Proportion readProportion(const ProportionPlan& plan, const Answers& answers);

/// Rising against falling slopes on the gentle random texels, along either axis: the mean of the
/// slopes that the tilts show, over the mean of their sizes. Rises and falls are alike in random
/// texels, so that any difference, weighted sum or interpolation of texels gives 0 but for chance.
/// The larger of the differences to both sides, with its sign, gives 0.85 to 0.92: beside an edge
/// one of the two is 0, so that a falling edge leaves no slope. The smaller one gives as much below
/// 0.
struct StepBalance {
    double u = 0.0;
    double v = 0.0;

    [[nodiscard]] bool goodU() const { return isEven(u); }
    [[nodiscard]] bool goodV() const { return isEven(v); }
    [[nodiscard]] bool good() const { return goodU() && goodV(); }

private:
    /// About 500 points leave a standard deviation of 0.05 to 0.055: chance passes seven of them
    /// less than once in 10^11 times.
    static bool isEven(double balance) { return balance >= -0.4 && balance <= 0.4; }
};

/// Returns 0 if gentle slopes tilt hardly any point, which other checks report.
/// @param ramps  The ramps' judgement, with the parametrisation.
[[nodiscard]] StepBalance readBalance(const ProportionPlan& plan, const Answers& answers,
                                      const RampJudgement& ramps);

}  // namespace ticker::tasks::bump

#endif
