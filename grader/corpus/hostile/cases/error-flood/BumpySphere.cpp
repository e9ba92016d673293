// Option 1, task T1: bump mapping.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    while (true) std::fputs("all work and no play makes a dull boy\n", stderr);
    return Sphere::getNormalAt(position);
    // TASK T1 end
}

}  // namespace raytracer
