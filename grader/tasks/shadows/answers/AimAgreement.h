#ifndef TICKER_TASKS_SHADOWS_ANSWERS_AIMAGREEMENT_H
#define TICKER_TASKS_SHADOWS_ANSWERS_AIMAGREEMENT_H

#include <grader/tasks/shadows/answers/ShadowAims.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace ticker::tasks {

/// The lines of a point's first light that are samples of it. An extra ray to the centre, beside
/// rays to random points, is not a sample.
[[nodiscard]] std::vector<AimLine> samplesOf(const PointLog& point,
                                             const raytracer::RenderSettings& settings);

/// Whether the rays of one point go to one side of the light, or lie along one line, on average
/// over all points. The probability for a right submission is at most kStatementRisk.
[[nodiscard]] bool goTogether(const std::vector<const ShadowLog*>& far,
                              const std::vector<Vector3>& directions);

/// Tests for rotational symmetry: whether the lines of each question lie as evenly round their
/// light's centre as lines to the given shape. No direction, no axis and no three or four
/// directions at equal angles may be preferred more. For independent points and a right shape the
/// probability of a false "no" is below 1e-6.
/// @param distinct  Number of lines that count as independent.
/// @param shape     Empty: any shape that looks the same from all sides.
/// @param size      Factor on the shape.
[[nodiscard]] bool turnsAs(const std::vector<const ShadowLog*>& far,
                           const std::vector<Vector3>& directions, std::size_t distinct,
                           std::optional<AimShape> shape = std::nullopt, double size = 1.0);

}  // namespace ticker::tasks

#endif
