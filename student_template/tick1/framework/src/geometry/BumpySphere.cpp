#include <raytracer/geometry/BumpySphere.h>

namespace raytracer {

// The main tick has no bumps.
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    return Sphere::getNormalAt(position);
}

}  // namespace raytracer
