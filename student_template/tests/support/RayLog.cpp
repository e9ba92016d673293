#include <support/RayLog.h>

#include <algorithm>
#include <cmath>

namespace raytracer::tests {

void RayLog::traceBegan(const Ray& ray, int bouncesLeft) {
    if (ray.origin.z > kNearestSurface) return;
    const std::lock_guard lock{mutex_};
    mostBounces_ = std::max(mostBounces_, bouncesLeft);
}

void RayLog::rayCast(const Ray& ray, const RaycastHit* /*hit*/) {
    const Ray unit{ray.origin, ray.direction.normalised()};
    if (!std::isfinite(unit.direction.x + unit.origin.x)) return;
    const std::lock_guard lock{mutex_};
    rays_.push_back(unit);
}

}  // namespace raytracer::tests
