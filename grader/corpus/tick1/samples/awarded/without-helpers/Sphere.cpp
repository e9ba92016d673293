#include <raytracer/geometry/Sphere.h>

#include <cmath>

namespace raytracer {

std::optional<RaycastHit> Sphere::intersectionWith(const Ray& ray) const {
    // TASK M1 begin
    Vector3 oc = ray.origin - centre();
    double b = 2 * oc.dot(ray.direction);
    double c = oc.dot(oc) - radius() * radius();
    double a = ray.direction.dot(ray.direction);
    double disc = b * b - 4 * a * c;
    if (disc < 0) return {};
    double s = (-b - std::sqrt(disc)) / (2 * a);
    if (s <= 0) s = (-b + std::sqrt(disc)) / (2 * a);
    if (s <= 0) return {};
    Vector3 p = ray.evaluateAt(s);
    return RaycastHit{this, s, p, getNormalAt(p)};
    // TASK M1 end
}

}  // namespace raytracer
