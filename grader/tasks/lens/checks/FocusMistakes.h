#ifndef TICKER_TASKS_LENS_CHECKS_FOCUSMISTAKES_H
#define TICKER_TASKS_LENS_CHECKS_FOCUSMISTAKES_H

#include <grader/result/Finding.h>
#include <grader/tasks/lens/answers/LensLog.h>

namespace ticker::tasks {

/// Tolerance for the distance between a right ray and its focal point, world units. A ray in single
/// precision misses it by about 1e-6; every known mistake misses it by more than 1e-2.
inline constexpr double kFocusSlack = 2e-4;

/// Distance of the point from the ray's line.
[[nodiscard]] double distanceFrom(const LensRay& ray, const Vector3& point);

/// Whether the rays of each pixel meet in one point, at any place.
[[nodiscard]] bool meetInPoints(const LensLog& log);

/// Explains rays that miss their focal points.
[[nodiscard]] Finding explainFocus(const LensLog& log);

}  // namespace ticker::tasks

#endif
