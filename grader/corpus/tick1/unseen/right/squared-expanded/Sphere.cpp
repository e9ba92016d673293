// Task M1: where a ray meets a sphere. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/Sphere.h>

#include <algorithm>
#include <cmath>

namespace raytracer {

std::optional<RaycastHit> Sphere::intersectionWith(const Ray& ray) const {
    // TASK M1 begin
    const auto hitAt = [&](double s) -> std::optional<RaycastHit> {
        const Vector3 X = ray.origin + s * ray.direction;
        return RaycastHit{this, s, X, (X - centre()).normalised()};
    };
    const Vector3 w = ray.origin - centre();
    const double a = ray.direction.dot(ray.direction);
    const double b = 2.0 * w.dot(ray.direction);
    const double c = w.dot(w) - radius() * radius();
    const double disc = b * b - 4.0 * a * c;
    if (!(disc >= 0.0)) return std::nullopt;
    const double s1 = (-b - std::sqrt(disc)) / (2.0 * a);
    const double s2 = (-b + std::sqrt(disc)) / (2.0 * a);
    return s1 > 0.0 ? hitAt(s1) : s2 > 0.0 ? hitAt(s2) : std::nullopt;
    // TASK M1 end
}

}  // namespace raytracer
