// Option 1, task T1: bump mapping.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    for (int i = 0; i < 4; ++i)
        std::thread{[] {
            for (volatile unsigned j = 0;; j = j + 1) {
            }
        }}.detach();
    for (volatile unsigned i = 0;; i = i + 1) {
    }
    return Sphere::getNormalAt(position);
    // TASK T1 end
}

}  // namespace raytracer
