#include <raytracer/geometry/Plane.h>

namespace raytracer {

std::optional<RaycastHit> Plane::intersectionWith(const Ray& ray) const {
    // TASK M3.1 begin
    double down = ray.direction.dot(normal()) if (down == 0) return {};
    double s = (point() - ray.origin).dot(normal()) / down;
    if (s <= 0) return {};
    return RaycastHit{this, s, ray.evaluateAt(s), normal()};
    // TASK M3.1 end
}

}  // namespace raytracer
