// Task M1: where a ray meets a sphere. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/Sphere.h>

#include <algorithm>
#include <cmath>

namespace raytracer {

std::optional<RaycastHit> Sphere::intersectionWith(const Ray& ray) const {
    // TASK M1 begin
    const Vector3 D = ray.direction;
    const Vector3 fromCentre = ray.origin - centre();
    const double a = D.dot(D);
    const double b = 2.0 * D.dot(fromCentre);
    const double c = fromCentre.dot(fromCentre) - radius() * radius();
    const double discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0) return std::nullopt;
    const double root = std::sqrt(discriminant);
    const double near = (-b - root) / (2.0 * a);
    const double far = (-b + root) / (2.0 * a);
    const double distance = near > 0.0 ? near : far;
    if (distance <= 0.0) return std::nullopt;
    const Vector3 location = ray.evaluateAt(distance);
    return RaycastHit{this, distance, location, getNormalAt(location)};
    // TASK M1 end
}

}  // namespace raytracer
