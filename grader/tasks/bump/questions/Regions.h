#ifndef TICKER_TASKS_BUMP_REGIONS_H
#define TICKER_TASKS_BUMP_REGIONS_H

#include <grader/tasks/bump/answers/RampJudgement.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace ticker::tasks::bump {

/// One large map that falls along both axes everywhere, in whole bytes. The tilts must be as on the
/// ramps at all its columns and rows. It is smaller than usual pictures: code that copies the map
/// in every call is slow, but right. The ramps are as long as pictures.
struct RegionPlan {
    std::vector<Vector3> directions;
    std::size_t question = 0;
};

/// @param directions  Points to ask for; the function draws more.
[[nodiscard]] RegionPlan planRegions(Questionnaire& questionnaire, Draws& draws, const Ball& ball,
                                     std::vector<Vector3> directions);

/// Texels from `first` to `last`.
struct TexelRange {
    int first = 0;
    int last = 0;
};

/// Result for one axis over the whole map.
struct RegionShares {
    double asOnRamps = 1.0;  ///< share of the points that tilt along this axis as on the ramps
    double worst = 1.0;      ///< that share in the worst region (a 48th of the sphere)
    double best = 0.0;       ///< that share in the best region
    /// Range with most of the wrong points, to a 64th of the map; empty if they lie everywhere.
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
    /// Some regions are right and others wrong.
    [[nodiscard]] bool isLocal() const { return u.isLocal() || v.isLocal(); }
};

/// @param ramps  The ramps' judgement, with the parametrisation.
[[nodiscard]] RegionAgreement readRegions(const RegionPlan& plan, const Answers& answers,
                                          const RampJudgement& ramps);

/// Compares the normals of two questions at the same points. True if they are equal although the
/// maps differ: the code remembers the map before.
[[nodiscard]] bool areTheSame(const Answers& answers, std::size_t question, std::size_t other);

}  // namespace ticker::tasks::bump

#endif
