// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1., 1.));
    const HeightMap& map = heightMap();
    const int i = std::clamp(int((lambda / std::numbers::pi + 1) / 2 * map.width()), 0, map.width() - 1);
    const int j = std::clamp(int(theta / std::numbers::pi * map.height()), 0, map.height() - 1);
    const double bu = map.at((i + 1) % map.width(), j) - map.at(i, j);
    const double bv = map.at(i, std::min(j + 1, map.height() - 1)) - map.at(i, j);

    const Vector3 e{std::cos(lambda), 0, std::sin(lambda)};
    const Vector3 s{std::sin(lambda) * std::cos(theta), -std::sin(theta), -std::cos(lambda) * std::cos(theta)};
    const Vector3 g = bu * e + bv * s;  // gradient of the height, in the tangent plane

    // columns of M = I + n g^T
    const Vector3 a = Vector3{1, 0, 0} + n * g.x;
    const Vector3 b = Vector3{0, 1, 0} + n * g.y;
    const Vector3 c = Vector3{0, 0, 1} + n * g.z;
    // det(M) M^-T has the columns b x c, c x a, a x b; det is 1 + g.n = 1
    return (b.cross(c) * n.x + c.cross(a) * n.y + a.cross(b) * n.z).normalised();
    // TASK T1 end
}

}  // namespace raytracer
