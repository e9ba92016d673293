#ifndef TICKER_DECISION_BUMP_EXAMINATION_H
#define TICKER_DECISION_BUMP_EXAMINATION_H

#include <grader/decision/bump/Conduct.h>
#include <grader/decision/bump/Letters.h>
#include <grader/decision/bump/RampJudgement.h>
#include <grader/decision/bump/Ramps.h>
#include <grader/decision/bump/Slopes.h>
#include <grader/decision/bump/Tilt.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace ticker::decision::bump {

/// The first sitting: everything that a right submission is asked.
struct MainPlan {
    Questionnaire questionnaire;
    RampPlan gentle;    ///< heights of 0 to 0.1: tilts are in proportion to slopes
    RampPlan moderate;  ///< heights of 0 to 1: ten times that, where the gentle ones tilt little
    RampPlan steep;     ///< heights of 0 to 5, as maps have them
    SlopePlan slopes;
    LetterPlan letters;
    ConductPlan conduct;
};

[[nodiscard]] MainPlan planMain(std::uint64_t seed);

/// The second sitting, which only a failing submission sees: where does it do better?
struct HintPlan {
    Questionnaire questionnaire;
    RampPlan square;       ///< columns and rows may be exchanged without harm
    RampPlan unitSphere;   ///< centre at the origin, radius 1
    RampPlan sceneSphere;  ///< the exercise's own sphere
};

[[nodiscard]] HintPlan planHints(std::uint64_t seed);

/// What the first sitting showed.
struct Examination {
    Conduct conduct;
    RampJudgement ramps;         ///< on the gentlest ramps that tilt clearly
    double flatTilt = 0.0;       ///< largest middle tilt on maps without slope
    bool growsWithSlope = true;  ///< 50 times the slope tilts at least twice as much
    bool steepAgrees = true;     ///< steep ramps tilt in the same directions as gentle ones
    std::optional<SlopeAgreement> slopes;  ///< where the map's place is known
    std::optional<LetterReading> letters;  ///< likewise
};

[[nodiscard]] Examination examine(const MainPlan& plan, const Answers& answers);

/// What the second sitting showed.
struct Hints {
    RampJudgement square;
    RampJudgement unitSphere;
    RampJudgement sceneSphere;
};

[[nodiscard]] Hints readHints(const HintPlan& plan, const Answers& answers);

}  // namespace ticker::decision::bump

#endif
