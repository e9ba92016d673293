#ifndef TICKER_DECISION_DISTRIBUTED_AIMAGREEMENT_H
#define TICKER_DECISION_DISTRIBUTED_AIMAGREEMENT_H

#include <grader/decision/distributed/ShadowLog.h>

#include <vector>

namespace ticker::decision {

/// The lines of a point's first light that are samples of it: an extra ray to the very centre,
/// beside those to random points, is none.
[[nodiscard]] std::vector<AimLine> samplesOf(const PointLog& point,
                                             const raytracer::RenderSettings& settings);

/// Whether the rays of one point go to one side of the light, or lie along one line, in the mean
/// over all points. Right submissions do so with a chance of at most kStatementRisk.
/// @param far         Logs of far lights, whose points draw independently of each other.
/// @param directions  Unit, from each log's points to its light.
[[nodiscard]] bool goTogether(const std::vector<const ShadowLog*>& far,
                              const std::vector<Vector3>& directions);

/// Whether the lines of each question lie round its light's centre as evenly as they must where the
/// light looks the same from all sides: no two, three or four directions are preferred. Lines in
/// such directions at random, or in pairs of opposite ones, fail with a chance below 1e-6.
/// @param distinct  Lines that can count as independent.
[[nodiscard]] bool looksRound(const std::vector<const ShadowLog*>& far,
                              const std::vector<Vector3>& directions, std::size_t distinct);

}  // namespace ticker::decision

#endif
