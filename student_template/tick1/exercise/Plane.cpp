// Task M3.1: where a ray meets a plane. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/Plane.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace raytracer {

std::optional<RaycastHit> Plane::intersectionWith(const Ray& ray) const {
    // TASK M3.1 begin
    unfinished("M3.1", "work out where the ray meets the plane; until then it meets no plane");
    std::ignore = ray;
    return std::nullopt;
    // TASK M3.1 end
}

}  // namespace raytracer
