// Task M3.1: where a ray meets a plane. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/Plane.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace raytracer {

std::optional<RaycastHit> Plane::intersectionWith(const Ray& ray) const {
    // TASK M3.1 begin
    const double slope = ray.direction.dot(normal());
    if (slope == 0.0) return std::nullopt;
    const double s = (point() - ray.origin).dot(normal()) / slope;
    if (s <= 0.0) return std::nullopt;
    return RaycastHit{this, s, ray.evaluateAt(s), normal()};
    // TASK M3.1 end
}

}  // namespace raytracer
