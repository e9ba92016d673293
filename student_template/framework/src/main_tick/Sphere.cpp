#include "Distances.h"

#include <cmath>

namespace raytracer {

std::optional<RaycastHit> Sphere::intersectionWith(const Ray& ray) const {
    const double distance = distanceTo(*this, ray);
    if (std::isinf(distance)) return std::nullopt;
    const Vector3 location = ray.evaluateAt(distance);
    return RaycastHit{this, distance, location, getNormalAt(location)};
}

}  // namespace raytracer
