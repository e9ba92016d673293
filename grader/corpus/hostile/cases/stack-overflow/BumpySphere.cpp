// Option 1, task T1: bump mapping.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    volatile double room[512] = {position.x};
    return getNormalAt(position) * room[0];
    // TASK T1 end
}

}  // namespace raytracer
