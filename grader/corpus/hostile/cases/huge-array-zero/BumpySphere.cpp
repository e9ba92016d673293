// Option 1, task T1: bump mapping.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

char room[10ULL << 30U];

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    room[static_cast<unsigned>(position.x)] = 1;
    return Sphere::getNormalAt(position);
    // TASK T1 end
}

}  // namespace raytracer
