// Option 1, task T1: bump mapping.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

constexpr unsigned long long fibonacci(int n, int salt) {
    return n < 2 ? static_cast<unsigned long long>(salt)
                 : fibonacci(n - 1, salt + 1) + fibonacci(n - 2, salt + 2);
}
constexpr unsigned long long kNumber = fibonacci(90, 0);

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    return Sphere::getNormalAt(position);
    // TASK T1 end
}

}  // namespace raytracer
