// Task M3.1: where a ray meets a plane. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/Plane.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace raytracer {

std::optional<RaycastHit> Plane::intersectionWith(const Ray& ray) const {
    // TASK M3.1 begin
    // n . x = k for all points x of the plane.
    const Vector3& n = normal();
    const double k = n.x * point().x + n.y * point().y + n.z * point().z;
    const double nO = n.x * ray.origin.x + n.y * ray.origin.y + n.z * ray.origin.z;
    const double nD = n.x * ray.direction.x + n.y * ray.direction.y + n.z * ray.direction.z;
    if (std::abs(nD) < 1e-12) return std::nullopt;
    const double s = (k - nO) / nD;
    if (s > 0) {
        const Vector3 X{ray.origin.x + s * ray.direction.x, ray.origin.y + s * ray.direction.y,
                        ray.origin.z + s * ray.direction.z};
        return RaycastHit{this, s, X, n};
    }
    return std::nullopt;
    // TASK M3.1 end
}

}  // namespace raytracer
