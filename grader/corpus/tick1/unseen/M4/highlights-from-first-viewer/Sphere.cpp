// Task M1: where a ray meets a sphere. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/Sphere.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace raytracer {

std::optional<RaycastHit> Sphere::intersectionWith(const Ray& ray) const {
    // TASK M1 begin
    const Vector3 fromCentre = ray.origin - centre();
    const double a = ray.direction.dot(ray.direction);
    const double b = 2.0 * ray.direction.dot(fromCentre);
    const double c = fromCentre.dot(fromCentre) - std::pow(radius(), 2);
    const double discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0) return std::nullopt;
    const double root = std::sqrt(discriminant);
    const std::array<double, 2> candidates{(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)};
    const auto seen =
        std::find_if(candidates.begin(), candidates.end(), [](double s) { return s > 0.0; });
    if (seen == candidates.end()) return std::nullopt;
    const Vector3 location = ray.evaluateAt(*seen);
    return RaycastHit{this, *seen, location, getNormalAt(location)};
    // TASK M1 end
}

}  // namespace raytracer
