#ifndef TICKER_TASKS_SHADOWS_MIXED_CLEARLIGHTS_H
#define TICKER_TASKS_SHADOWS_MIXED_CLEARLIGHTS_H

#include <grader/tasks/support/Surfaces.h>

namespace ticker::tasks {

// Whether no accepted reading is near a decision about a light, seen from a point.

/// Seen from `point`, each ray belongs clearly to one of two lights.
[[nodiscard]] bool areApart(const raytracer::PointLight& one, const raytracer::PointLight& other,
                            const raytracer::Vector3& point, double lightSize);

/// The light is all in front of the surface's tangent plane, or all behind it.
[[nodiscard]] bool isOffHorizon(const raytracer::PointLight& light, const raytracer::Vector3& point,
                                const raytracer::Vector3& normal, double lightSize);

/// The light is so far away that `questions::seenFrom` recognises a ray that was cast from any
/// place of it to the point.
[[nodiscard]] bool isFarOff(const raytracer::PointLight& light, const raytracer::Vector3& point,
                            double lightSize);

/// The light is in front, or R.V is negative for every place of it.
[[nodiscard]] bool showsNoHighlightFromBehind(const raytracer::PointLight& light,
                                              const raytracer::Vector3& point,
                                              const raytracer::Vector3& normal,
                                              const raytracer::Vector3& viewer, double lightSize);

}  // namespace ticker::tasks

#endif
