// Option 1, task T1: bump mapping.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

constexpr unsigned long long spin() {
    unsigned long long sum = 0;
    for (unsigned long long i = 0; i < 1'000'000'000'000; ++i) sum += i * i;
    return sum;
}
constexpr unsigned long long kSum = spin();

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    return Sphere::getNormalAt(position);
    // TASK T1 end
}

}  // namespace raytracer
