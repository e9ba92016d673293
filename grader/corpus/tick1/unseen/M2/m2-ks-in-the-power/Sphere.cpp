// Task M1: where a ray meets a sphere. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/Sphere.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace raytracer {

std::optional<RaycastHit> Sphere::intersectionWith(const Ray& ray) const {
    // TASK M1 begin
    const Vector3 m = ray.origin - centre();
    const double a = ray.direction.dot(ray.direction);
    const double h = ray.direction.dot(m);  // b / 2
    const double c = m.dot(m) - radius() * radius();
    const double quarter = h * h - a * c;
    if (quarter < 0.0) return std::nullopt;

    // Never subtract two numbers of nearly the same size.
    const double q = -(h + std::copysign(std::sqrt(quarter), h));
    if (q == 0.0) return std::nullopt;
    double first = q / a;
    double second = c / q;
    if (second < first) std::swap(first, second);
    for (const double s : {first, second}) {
        if (!(s > 0.0)) continue;
        const Vector3 X = ray.evaluateAt(s);
        return RaycastHit{this, s, X, (X - centre()) / radius()};
    }
    return std::nullopt;
    // TASK M1 end
}

}  // namespace raytracer
