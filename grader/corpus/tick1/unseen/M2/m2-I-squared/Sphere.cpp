// Task M1: where a ray meets a sphere. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/Sphere.h>

#include <algorithm>
#include <cmath>

namespace raytracer {

std::optional<RaycastHit> Sphere::intersectionWith(const Ray& ray) const {
    // TASK M1 begin
    using Real = long double;
    const Real ox = Real{ray.origin.x} - centre().x;
    const Real oy = Real{ray.origin.y} - centre().y;
    const Real oz = Real{ray.origin.z} - centre().z;
    const Real dx = ray.direction.x, dy = ray.direction.y, dz = ray.direction.z;
    const Real r = radius();
    const Real a = dx * dx + dy * dy + dz * dz;
    const Real halfB = ox * dx + oy * dy + oz * dz;
    const Real c = ox * ox + oy * oy + oz * oz - r * r;
    const Real disc = halfB * halfB - a * c;
    if (disc < 0) return std::nullopt;
    const Real root = std::sqrt(disc);
    if (root <= halfB) return std::nullopt;  // even the farther one lies behind
    const bool inside = -halfB - root <= 0;
    const double s = static_cast<double>((inside ? root - halfB : -root - halfB) / a);
    const Vector3 location = ray.evaluateAt(s);
    return RaycastHit{this, s, location, getNormalAt(location)};
    // TASK M1 end
}

}  // namespace raytracer
