#include <raytracer/geometry/Plane.h>

#include <cmath>

namespace raytracer {

std::optional<RaycastHit> Plane::intersectionWith(const Ray& ray) const {
    const double distance = distanceAlong(ray);
    if (std::isinf(distance)) return std::nullopt;
    return RaycastHit{this, distance, ray.evaluateAt(distance), normal_};
}

Vector3 Plane::getNormalAt(const Vector3& /*position*/) const {
    return normal_;
}

}  // namespace raytracer
