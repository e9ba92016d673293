// Option 1, task T1: bump mapping.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    static char* volatile kept = nullptr;  // volatile: else the compiler leaves the leak out
    kept = new char[1U << 20U];
    std::memset(kept, 1, 1U << 20U);
    return Sphere::getNormalAt(position);
    // TASK T1 end
}

}  // namespace raytracer
