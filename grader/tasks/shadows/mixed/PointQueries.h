#ifndef TICKER_TASKS_SHADOWS_MIXED_POINTQUERIES_H
#define TICKER_TASKS_SHADOWS_MIXED_POINTQUERIES_H

#include <grader/tasks/shadows/mixed/ShadowTraits.h>

#include <algorithm>
#include <functional>

namespace ticker::tasks {

// What the traits ask about a point of a log, and about what is around it.

[[nodiscard]] const raytracer::Material& surfaceOf(const PointOfLog& at);

/// Distance from the point to the light's centre, world units.
[[nodiscard]] double distanceOf(const PointOfLog& at, const raytracer::PointLight& light);

/// Whether the light's centre is in front of the surface.
[[nodiscard]] bool isInFront(const PointOfLog& at, const raytracer::PointLight& light);

/// How many channels of the colour are above 0.
[[nodiscard]] int channelsOf(const ColourRGB& colour);

template <typename Test>
[[nodiscard]] bool anyLight(const PointOfLog& at, Test test) {
    return std::ranges::any_of(at.log->scene().pointLights, test);
}

/// Whether such an object stands between the point and the centre of a light.
/// @param test  Of a scene and the object's index.
[[nodiscard]] bool anyBlockerThat(
    const PointOfLog& at,
    const std::function<bool(const raytracer::SceneDescription&, int object)>& test);

/// The same, by the object's material.
[[nodiscard]] bool anyBlocker(const PointOfLog& at,
                              const std::function<bool(const raytracer::Material&)>& test);

/// Whether some object on the way to the centre of a light is nearer to that centre than this.
[[nodiscard]] bool anyBlockerWithin(const PointOfLog& at, double distance);

/// The sphere with this index among the objects; null for a plane.
[[nodiscard]] const raytracer::SphereDescription* sphereOf(const raytracer::SceneDescription& scene,
                                                           int object);

}  // namespace ticker::tasks

#endif
