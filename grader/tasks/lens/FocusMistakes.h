#ifndef TICKER_TASKS_DISTRIBUTED_FOCUSMISTAKES_H
#define TICKER_TASKS_DISTRIBUTED_FOCUSMISTAKES_H

#include <grader/result/Finding.h>
#include <grader/tasks/lens/LensLog.h>

namespace ticker::tasks {

/// How far a right ray may pass its focal point, world units. A ray made in single precision misses
/// it by some 1e-6; every mistake that is known misses it by more than 1e-2.
inline constexpr double kFocusSlack = 2e-4;

/// Of the point from the line on which the ray lies.
[[nodiscard]] double distanceFrom(const LensRay& ray, const Vector3& point);

/// Whether the rays of each pixel meet in one point, wherever that is.
[[nodiscard]] bool meetInPoints(const LensLog& log);

/// What the rays of a log do that miss their focal points.
[[nodiscard]] Finding explainFocus(const LensLog& log);

}  // namespace ticker::tasks

#endif
