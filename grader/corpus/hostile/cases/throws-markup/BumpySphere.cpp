// Option 1, task T1: bump mapping.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    throw std::runtime_error("</pre><script>alert(1)</script> =1+1 \x1b[2J");
    return Sphere::getNormalAt(position);
    // TASK T1 end
}

}  // namespace raytracer
