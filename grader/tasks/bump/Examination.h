#ifndef TICKER_TASKS_BUMP_EXAMINATION_H
#define TICKER_TASKS_BUMP_EXAMINATION_H

#include <grader/tasks/bump/answers/Letters.h>
#include <grader/tasks/bump/questions/CoarseRamps.h>
#include <grader/tasks/bump/questions/Conduct.h>
#include <grader/tasks/bump/questions/Fineness.h>
#include <grader/tasks/bump/questions/MapEdges.h>
#include <grader/tasks/bump/questions/Proportion.h>
#include <grader/tasks/bump/questions/RampLadder.h>
#include <grader/tasks/bump/questions/Regions.h>
#include <grader/tasks/bump/questions/Slopes.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace ticker::tasks::bump {

/// The first run: everything that a right submission is asked.
struct MainPlan {
    Questionnaire questionnaire;
    RegionPlan regions;  ///< first, at the ladder's points, so that what remembers a map shows
    RampLadder ladder;
    SlopePlan slopes;
    ProportionPlan proportion;
    EdgePlan edges;
    LetterPlan letters;
    ConductPlan conduct;
    FinenessPlan fineness;
};

[[nodiscard]] MainPlan planMain(std::uint64_t seed);

/// The second run, for a submission whose ramps do not tell where the map lies.
[[nodiscard]] CoarsePlan planCoarse(std::uint64_t seed);

/// The last run, which only a failing submission sees: where does it do better?
struct HintPlan {
    Questionnaire questionnaire;
    RampPlan square;              ///< columns and rows may be exchanged without harm
    RampPlan unitSphere;          ///< centre at the origin, radius 1
    RampPlan sceneSphere;         ///< the exercise's own sphere
    std::size_t lastColumns = 0;  ///< a map that slopes in its last columns only
    std::size_t lastRows = 0;
    std::size_t forwards = 0;   ///< one map at the same points,
    std::size_t backwards = 0;  ///< in the opposite order
};

[[nodiscard]] HintPlan planHints(std::uint64_t seed);

/// What the runs before the last showed.
struct Examination {
    Conduct conduct;
    bool mapIgnored = false;  ///< two maps on the same sphere gave the same tilts
    LadderJudgement ladder;
    Proportion proportion;
    std::optional<RegionAgreement> regions;  ///< where the map's place is known, as are the next
    std::optional<SlopeAgreement> slopes;
    std::optional<MapEdges> edges;
    std::optional<LetterReading> letters;
    std::optional<Fineness> fineness;

    [[nodiscard]] const RampJudgement& ramps() const { return ladder.ramps; }
    /// Every map says what the ramps said.
    [[nodiscard]] bool agreesWithRamps() const;
};

/// @param coarse  From a run of its own; counts where other ramps do not tell the map's place.
[[nodiscard]] Examination examine(const MainPlan& plan, const Answers& answers,
                                  const std::optional<RampJudgement>& coarse = std::nullopt);

/// What the last run showed.
struct Hints {
    RampJudgement square;
    RampJudgement unitSphere;
    RampJudgement sceneSphere;
    bool lastColumnsSeen = true;  ///< the map's last columns lie somewhere on the sphere
    bool lastRowsSeen = true;
    bool dependsOnOrder = false;  ///< the normal at a point depends on what was asked before
};

[[nodiscard]] Hints readHints(const HintPlan& plan, const Answers& answers);

}  // namespace ticker::tasks::bump

#endif
