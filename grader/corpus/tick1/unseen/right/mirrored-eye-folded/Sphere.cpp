// Task M1: where a ray meets a sphere. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/Sphere.h>

#include <algorithm>
#include <cmath>

namespace raytracer {

std::optional<RaycastHit> Sphere::intersectionWith(const Ray& ray) const {
    // TASK M1 begin
    const Vector3 OC = ray.origin - this->centre();
    const double b = 2 * ray.direction.dot(OC);
    const double c = OC.dot(OC) - this->radius() * this->radius();
    const bool outside = c > 0;
    // From outside, a ray that moves away never comes back.
    if (outside && b >= 0) return std::nullopt;
    const double a = ray.direction.dot(ray.direction);
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return std::nullopt;
    const double sign = outside ? -1.0 : 1.0;
    const double s = (-b + sign * std::sqrt(discriminant)) / (2 * a);
    if (s <= 0) return std::nullopt;
    RaycastHit hit;
    hit.object = this;
    hit.distance = s;
    hit.location = ray.evaluateAt(s);
    hit.normal = getNormalAt(hit.location);
    return hit;
    // TASK M1 end
}

}  // namespace raytracer
