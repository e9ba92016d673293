// Task M3.1: where a ray meets a plane. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/Plane.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace raytracer {

std::optional<RaycastHit> Plane::intersectionWith(const Ray& ray) const {
    // TASK M3.1 begin
    const double numerator = (point() - ray.origin).dot(normal());
    const double denominator = ray.direction.dot(normal());
    const bool towards = (numerator > 0.0 && denominator > 0.0) || (numerator < 0.0 && denominator < 0.0);
    if (!towards) return std::nullopt;
    const double s = numerator / denominator;
    return RaycastHit{this, s, ray.evaluateAt(s), normal()};
    // TASK M3.1 end
}

}  // namespace raytracer
