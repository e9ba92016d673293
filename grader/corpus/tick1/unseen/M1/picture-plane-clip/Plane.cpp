// Task M3.1: where a ray meets a plane. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/Plane.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace raytracer {

std::optional<RaycastHit> Plane::intersectionWith(const Ray& ray) const {
    // TASK M3.1 begin
    // How high the ray starts above the plane, and how fast it comes down.
    const double height = (ray.origin - point()).dot(normal());
    const double fall = -ray.direction.dot(normal());
    if (fall == 0.0) return std::nullopt;
    const double s = height / fall;
    if (!(s > 0.0)) return std::nullopt;
    const Vector3 location = ray.origin + ray.direction * s;
    return RaycastHit{this, s, location, getNormalAt(location)};
    // TASK M3.1 end
}

}  // namespace raytracer
