#ifndef RAYTRACER_SCENE_NEAREST_H
#define RAYTRACER_SCENE_NEAREST_H

#include <raytracer/geometry/SceneObject.h>

#include <limits>
#include <optional>

namespace raytracer {

/// The first hit of a ray in short form, small enough to be returned in registers.
struct Nearest {
    double distance = std::numeric_limits<double>::infinity();  ///< in lengths of the direction
    const SceneObject* object = nullptr;                        ///< null: a miss

    /// The hit with its location and normal; empty for a miss.
    /// @param ray  The ray that this is the nearest hit of.
    [[nodiscard]] std::optional<RaycastHit> hitOf(const Ray& ray) const {
        std::optional<RaycastHit> hit;
        if (object != nullptr) {
            hit.emplace();
            hit->object = object;
            hit->distance = distance;
            hit->location = ray.evaluateAt(distance);
            hit->normal = object->getNormalAt(hit->location);
        }
        return hit;
    }
};

}  // namespace raytracer

#endif
