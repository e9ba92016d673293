#ifndef TICKER_TASKS_DISTRIBUTED_AIMAGREEMENT_H
#define TICKER_TASKS_DISTRIBUTED_AIMAGREEMENT_H

#include <grader/tasks/shadows/answers/ShadowAims.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace ticker::tasks {

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

/// Whether the lines of each question lie round their light's centre as evenly as those to a shape
/// do: no direction, no line, no three and no four directions are preferred more than there. Lines
/// that do, in points that are independent of each other, fail with a chance below 1e-6.
/// @param distinct  Lines that can count as independent.
/// @param shape     None: any that looks the same from all sides.
/// @param size      By which the shape is multiplied.
[[nodiscard]] bool turnsAs(const std::vector<const ShadowLog*>& far,
                           const std::vector<Vector3>& directions, std::size_t distinct,
                           std::optional<AimShape> shape = std::nullopt, double size = 1.0);

}  // namespace ticker::tasks

#endif
