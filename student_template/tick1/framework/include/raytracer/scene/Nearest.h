#ifndef RAYTRACER_SCENE_NEAREST_H
#define RAYTRACER_SCENE_NEAREST_H

#include <raytracer/geometry/RaycastHit.h>
#include <raytracer/math/Ray.h>

#include <optional>

namespace raytracer {

/// The first hit of a ray, as the object itself tells it; empty: a miss.
struct Nearest {
    std::optional<RaycastHit> hit;

    [[nodiscard]] const std::optional<RaycastHit>& hitOf(const Ray& /*ray*/) const { return hit; }
};

}  // namespace raytracer

#endif
