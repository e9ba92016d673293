#include <raytracer/base/Error.h>
#include <raytracer/geometry/BumpySphere.h>

#include <utility>

namespace raytracer {

BumpySphere::BumpySphere(const Vector3& centre, double radius, const Material& material,
                         std::shared_ptr<const HeightMap> heightMap)
    : Sphere(centre, radius, material), heightMap_(std::move(heightMap)) {
    if (heightMap_ == nullptr) throw Error("a bumpy sphere needs a height map");
}

}  // namespace raytracer
