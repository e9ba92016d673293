#ifndef TICKER_TASKS_BUMP_FINENESS_H
#define TICKER_TASKS_BUMP_FINENESS_H

#include <grader/tasks/bump/answers/RampJudgement.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Slopes.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <vector>

namespace ticker::tasks::bump {

/// Zigzags that turn every `kHalf` texels, along u and along v, asked for at pairs of points that
/// lie so many texels apart where the map's poles are above and below.
struct FinenessPlan {
    static constexpr int kColumns = 2100;
    static constexpr int kRows = 1050;
    static constexpr int kHalf = 3;  ///< texels: half a degree on either axis

    std::vector<Vector3> pairsU;  ///< two by two
    std::vector<Vector3> pairsV;
    LevelPair zigzagU;  ///< at `pairsU`
    LevelPair zigzagV;
};

[[nodiscard]] FinenessPlan planFineness(Questionnaire& questionnaire, Draws& draws,
                                        const Ball& ball);

/// How surely two points of a pair tilt opposite ways: 1 always, -1 never. Whatever difference,
/// interpolation or smoothing a code takes, a zigzag's slope turns round in half a period. Who
/// rounds u to whole degrees reads the same texel twice, or one that is a whole period away.
struct Fineness {
    double u = 1.0;
    double v = 1.0;

    [[nodiscard]] bool goodU() const { return u >= 0.0; }
    [[nodiscard]] bool goodV() const { return v >= 0.0; }
    [[nodiscard]] bool good() const { return goodU() && goodV(); }
};

/// Says 1 where the question does not fit: with poles elsewhere, and where a wide difference
/// smooths the zigzag away.
/// @param ramps  What the ramps said; they told the map's place.
[[nodiscard]] Fineness readFineness(const FinenessPlan& plan, const Answers& answers,
                                    const RampJudgement& ramps);

}  // namespace ticker::tasks::bump

#endif
