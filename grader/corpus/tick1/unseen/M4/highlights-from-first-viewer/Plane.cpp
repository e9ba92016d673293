// Task M3.1: where a ray meets a plane. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/Plane.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace raytracer {

std::optional<RaycastHit> Plane::intersectionWith(const Ray& ray) const {
    // TASK M3.1 begin
    const double s = (point() - ray.origin).dot(normal()) / ray.direction.dot(normal());
    // A parallel ray gives an infinity or no number at all.
    if (!std::isfinite(s) || s <= 0.0) return std::nullopt;
    RaycastHit hit;
    hit.object = this;
    hit.distance = s;
    hit.location = ray.evaluateAt(s);
    hit.normal = normal();
    return hit;
    // TASK M3.1 end
}

}  // namespace raytracer
