#ifndef TICKER_TASKS_SHADOWS_MIXED_CLEARLIGHTS_H
#define TICKER_TASKS_SHADOWS_MIXED_CLEARLIGHTS_H

#include <grader/tasks/support/Surfaces.h>

namespace ticker::tasks {

// Margins of a light, seen from a point: where they hold, no accepted reading is near a decision.

/// Whether each ray from `point` belongs clearly to one of two lights.
[[nodiscard]] bool areApart(const raytracer::PointLight& one, const raytracer::PointLight& other,
                            const raytracer::Vector3& point, double lightSize);

/// Whether the whole light is in front of the surface's tangent plane, or all of it behind.
[[nodiscard]] bool isOffHorizon(const raytracer::PointLight& light, const raytracer::Vector3& point,
                                const raytracer::Vector3& normal, double lightSize);

/// Whether the light is so far away that `questions::seenFrom` recognises a ray that was cast from
/// any place of it to the point.
[[nodiscard]] bool isFarOff(const raytracer::PointLight& light, const raytracer::Vector3& point,
                            double lightSize);

/// Whether the light is in front, or R.V is negative for every place of it.
[[nodiscard]] bool showsNoHighlightFromBehind(const raytracer::PointLight& light,
                                              const raytracer::Vector3& point,
                                              const raytracer::Vector3& normal,
                                              const raytracer::Vector3& viewer, double lightSize);

}  // namespace ticker::tasks

#endif
