#ifndef TICKER_TASKS_BUMP_REGIONS_H
#define TICKER_TASKS_BUMP_REGIONS_H

#include <grader/tasks/bump/answers/RampJudgement.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace ticker::tasks::bump {

/// One large map, which falls along both axes everywhere, in whole bytes: what a code does on the
/// ramps it must do at every column and row of this, too. Not as large as pictures are: code that
/// copies the map in every call is slow, but right. The ramps are as long as pictures.
struct RegionPlan {
    std::vector<Vector3> directions;
    std::size_t question = 0;
};

/// @param directions  Points to ask for; more are drawn.
[[nodiscard]] RegionPlan planRegions(Questionnaire& questionnaire, Draws& draws, const Ball& ball,
                                     std::vector<Vector3> directions);

/// Texels from `first` to `last`.
struct TexelRange {
    int first = 0;
    int last = 0;
};

/// How one axis does over the whole map.
struct RegionShares {
    double asOnRamps = 1.0;  ///< share of the points that tilt along this axis as on the ramps
    double worst = 1.0;      ///< that share in the worst region of a 48th of the sphere
    double best = 0.0;       ///< and in the best
    /// Where most of the others lie, unless that is everywhere; to a 64th of the map.
    std::optional<TexelRange> columns;
    std::optional<TexelRange> rows;

    [[nodiscard]] bool good() const;
    [[nodiscard]] bool isLocal() const { return best - worst > 0.5; }
};

struct RegionAgreement {
    RegionShares u;
    RegionShares v;
    int width = 0;  ///< of the map
    int height = 0;

    [[nodiscard]] bool good() const { return u.good() && v.good(); }
    /// Some regions are right, others not.
    [[nodiscard]] bool isLocal() const { return u.isLocal() || v.isLocal(); }
};

/// @param ramps  What the ramps said; they told the map's place.
[[nodiscard]] RegionAgreement readRegions(const RegionPlan& plan, const Answers& answers,
                                          const RampJudgement& ramps);

/// True where a map is no other than the one that was asked for before it: something is
/// remembered. Compares the normals of two questions at the same points.
[[nodiscard]] bool areTheSame(const Answers& answers, std::size_t question, std::size_t other);

}  // namespace ticker::tasks::bump

#endif
