// Option 1, task T1: bump mapping.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    int number = 2;
    asm volatile("int $0x80" : "+a"(number) : : "memory");
    return Sphere::getNormalAt(position);
    // TASK T1 end
}

}  // namespace raytracer
