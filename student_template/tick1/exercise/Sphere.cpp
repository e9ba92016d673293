// Task M1: where a ray meets a sphere. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/Sphere.h>

#include <algorithm>
#include <cmath>

namespace raytracer {

std::optional<RaycastHit> Sphere::intersectionWith(const Ray& ray) const {
    // TASK M1 begin
    unfinished("M1", "solve the quadratic; until then a sphere is a flat disc that faces the ray");
    const double distance = (centre() - ray.origin).dot(ray.direction);
    const Vector3 location = ray.evaluateAt(distance);
    if (distance <= 0.0 || (location - centre()).magnitude() >= radius()) return std::nullopt;
    return RaycastHit{this, distance, location, -ray.direction};
    // TASK M1 end
}

}  // namespace raytracer
