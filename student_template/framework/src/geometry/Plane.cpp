#include <raytracer/geometry/Plane.h>

#include <cmath>
#include <limits>

namespace raytracer {

double Plane::distanceAlong(const Ray& ray) const {
    const double distance = (point_ - ray.origin).dot(normal_) / ray.direction.dot(normal_);
    return distance > 0.0 ? distance : std::numeric_limits<double>::infinity();
}

std::optional<RaycastHit> Plane::intersectionWith(const Ray& ray) const {
    const double distance = distanceAlong(ray);
    if (std::isinf(distance)) return std::nullopt;
    return RaycastHit{this, distance, ray.evaluateAt(distance), normal_};
}

Vector3 Plane::getNormalAt(const Vector3& /*position*/) const {
    return normal_;
}

}  // namespace raytracer
