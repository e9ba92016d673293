#ifndef TICKER_TASKS_BUMP_EXAMINATION_H
#define TICKER_TASKS_BUMP_EXAMINATION_H

#include <grader/tasks/bump/answers/Letters.h>
#include <grader/tasks/bump/places/Belts.h>
#include <grader/tasks/bump/places/Caps.h>
#include <grader/tasks/bump/places/Elsewhere.h>
#include <grader/tasks/bump/places/EvenSteps.h>
#include <grader/tasks/bump/places/FewTexels.h>
#include <grader/tasks/bump/places/OwnTexels.h>
#include <grader/tasks/bump/places/Untilted.h>
#include <grader/tasks/bump/questions/CoarseRamps.h>
#include <grader/tasks/bump/questions/Conduct.h>
#include <grader/tasks/bump/questions/Fineness.h>
#include <grader/tasks/bump/questions/MapEdges.h>
#include <grader/tasks/bump/questions/Proportion.h>
#include <grader/tasks/bump/questions/RampLadder.h>
#include <grader/tasks/bump/questions/Regions.h>
#include <grader/tasks/bump/questions/SharpSteps.h>
#include <grader/tasks/bump/questions/Slopes.h>
#include <grader/tasks/bump/questions/Stripes.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace ticker::tasks::bump {

/// The first run: the questions that every submission gets.
struct MainPlan {
    Questionnaire questionnaire;
    RegionPlan regions;  ///< asked first, at the ladder's points: shows code that keeps a map
    RampLadder ladder;
    SlopePlan slopes;
    SharpStepPlan sharpSteps;
    ProportionPlan proportion;
    EdgePlan edges;
    LetterPlan letters;
    ConductPlan conduct;
    FinenessPlan fineness;
    StripePlan stripes;
    UntiltedPlan untilted;
    ElsewherePlan elsewhere;
    CapPlan caps;
    FewTexelPlan fewTexels;
    EvenStepPlan evenSteps;
    SharpStepPlan lightSteps;
    BeltPlan belts;
    OwnTexelPlan ownTexels;
    OrderPair order;  ///< a rough map of few rows, asked in both orders
};

[[nodiscard]] MainPlan planMain(std::uint64_t seed);

/// The second run, for a submission whose ramps do not show the parametrisation.
[[nodiscard]] CoarsePlan planCoarse(std::uint64_t seed);

/// The last run, for failing submissions only: special cases in which the code may be right, for
/// hints.
struct HintPlan {
    Questionnaire questionnaire;
    RampPlan square;              ///< as many rows as columns: exchanging them does no harm
    RampPlan unitSphere;          ///< centre at the origin, radius 1
    RampPlan sceneSphere;         ///< the exercise's own sphere
    RampPlan asideSphere;         ///< far to one side and below
    std::size_t lastColumns = 0;  ///< a map with slopes in its last columns only
    std::size_t lastRows = 0;
    OrderPair order;  ///< of a map with slopes in its last columns and rows
};

[[nodiscard]] HintPlan planHints(std::uint64_t seed);

/// Results of the first and second run.
struct Examination {
    Conduct conduct;
    bool mapIgnored = false;      ///< two maps on the same sphere gave the same tilts
    double changedByOrder = 0.0;  ///< share of the points of `order` whose normal depends on it
    LadderJudgement ladder;
    Proportion proportion;
    Untilted untilted;
    Elsewhere elsewhere;
    SharpSteps sharpSteps;  ///< the worse of `MainPlan::sharpSteps` and `lightSteps`
    std::optional<RegionAgreement> regions;  ///< this and all below need a known parametrisation
    std::optional<SlopeAgreement> slopes;
    std::optional<MapEdges> edges;
    std::optional<LetterReading> letters;
    std::optional<Fineness> fineness;
    std::optional<StepBalance> balance;
    std::optional<StripeAgreement> stripes;
    std::optional<Caps> caps;
    std::optional<FewTexels> fewTexels;
    std::optional<EvenSteps> evenSteps;
    std::optional<Belts> belts;
    std::optional<OwnTexels> ownTexels;

    [[nodiscard]] const RampJudgement& ramps() const { return ladder.ramps; }
    /// Whether the steep ramps, the large map and the maps of `SlopePlan` agree with the ramps.
    [[nodiscard]] bool agreesWithRamps() const;
};

/// @param coarse  The second run's result; used if the other ramps do not show the parametrisation.
[[nodiscard]] Examination examine(const MainPlan& plan, const Answers& answers,
                                  const std::optional<RampJudgement>& coarse = std::nullopt);

/// Results of the last run.
struct Hints {
    RampJudgement square;
    RampJudgement unitSphere;
    RampJudgement sceneSphere;
    RampJudgement asideSphere;
    bool lastColumnsSeen = true;  ///< the map's last columns are used somewhere on the sphere
    bool lastRowsSeen = true;
    bool dependsOnOrder = false;  ///< the normal at a point depends on the questions before it
};

[[nodiscard]] Hints readHints(const HintPlan& plan, const Answers& answers);

}  // namespace ticker::tasks::bump

#endif
