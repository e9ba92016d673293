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

}  // namespace ticker::decision

#endif
