// Option 1, task T1: bump mapping.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return Sphere::getNormalAt(position) * nan;
    // TASK T1 end
}

}  // namespace raytracer
