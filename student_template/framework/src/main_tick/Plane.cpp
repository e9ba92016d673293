#include "Distances.h"

#include <raytracer/geometry/Plane.h>

#include <cmath>

namespace raytracer {

std::optional<RaycastHit> Plane::intersectionWith(const Ray& ray) const {
    const double distance = distanceTo(point_, normal_, ray);
    if (std::isinf(distance)) return std::nullopt;
    return RaycastHit{this, distance, ray.evaluateAt(distance), normal_};
}

}  // namespace raytracer
