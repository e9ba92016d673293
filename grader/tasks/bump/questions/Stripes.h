#ifndef TICKER_TASKS_BUMP_STRIPES_H
#define TICKER_TASKS_BUMP_STRIPES_H

#include <grader/tasks/bump/answers/RampJudgement.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <vector>

namespace ticker::tasks::bump {

/// Random stripes: a map whose columns are each of one grey, and one whose rows are. Pairs of
/// points are asked for that lie at the same place across the stripes and at two places along them.
struct StripePlan {
    std::vector<Vector3> pairsU;  ///< one pair after the other: as far above the equator as below
    std::vector<Vector3> pairsV;  ///< of one polar angle
    LevelPair columns;            ///< at `pairsU`
    LevelPair rows;               ///< at `pairsV`
};

[[nodiscard]] StripePlan planStripes(Questionnaire& questionnaire, Draws& draws, const Ball& ball);

/// Correlation of the two tilts of a pair across the stripes. Whatever the difference,
/// interpolation and strength, it is 1: only the place along the stripes differs. An interpolation
/// that weighs rows with the fraction of the column gives 0 to 0.75 on average.
struct StripeAgreement {
    double u = 1.0;
    double v = 1.0;

    [[nodiscard]] bool goodU() const { return u >= 0.9; }
    [[nodiscard]] bool goodV() const { return v >= 0.9; }
    [[nodiscard]] bool good() const { return goodU() && goodV(); }
};

/// Returns 1 if the question does not apply: the map's poles are not above and below, or stripes
/// tilt hardly any point.
/// @param ramps  The ramps' judgement, with the parametrisation.
[[nodiscard]] StripeAgreement readStripes(const StripePlan& plan, const Answers& answers,
                                          const RampJudgement& ramps);

}  // namespace ticker::tasks::bump

#endif
