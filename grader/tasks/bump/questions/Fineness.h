#ifndef TICKER_TASKS_BUMP_FINENESS_H
#define TICKER_TASKS_BUMP_FINENESS_H

#include <grader/tasks/bump/answers/RampJudgement.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Slopes.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <vector>

namespace ticker::tasks::bump {

/// Zigzags that turn every `kHalf` texels, along u and along v. Pairs of points are asked for that
/// lie `kHalf` texels apart if the map's poles are above and below.
struct FinenessPlan {
    static constexpr int kColumns = 2100;
    static constexpr int kRows = 1050;
    static constexpr int kHalf = 3;  ///< texels: half a degree on either axis

    std::vector<Vector3> pairsU;  ///< one pair after the other
    std::vector<Vector3> pairsV;  ///< some of them 9 to 22 degrees from a pole
    LevelPair zigzagU;            ///< at `pairsU`
    LevelPair zigzagV;
};

[[nodiscard]] FinenessPlan planFineness(Questionnaire& questionnaire, Draws& draws,
                                        const Ball& ball);

/// Agreement of the two tilts of a pair: 1 if they are always opposite, -1 if they are always
/// equal. A zigzag's slope changes sign after half a period under every difference, interpolation
/// or smoothing. Code that rounds u to whole degrees reads the same texel twice, or one that is a
/// whole period away.
struct Fineness {
    double u = 1.0;
    double v = 1.0;

    [[nodiscard]] bool goodU() const { return u >= 0.0; }
    [[nodiscard]] bool goodV() const { return v >= 0.0; }
    [[nodiscard]] bool good() const { return goodU() && goodV(); }
};

/// Compares the tilts of the pairs. Returns 1 if the question does not apply: poles elsewhere, or a
/// wide difference that averages the zigzag out.
/// @param ramps  The ramps' judgement, with the parametrisation.
[[nodiscard]] Fineness readFineness(const FinenessPlan& plan, const Answers& answers,
                                    const RampJudgement& ramps);

}  // namespace ticker::tasks::bump

#endif
