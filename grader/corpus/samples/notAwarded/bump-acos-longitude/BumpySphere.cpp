#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const double ring = std::max(1e-9, std::sqrt(n.x * n.x + n.z * n.z));
    const double u = 1.0 - std::acos(std::clamp(n.x / ring, -1.0, 1.0)) / std::numbers::pi;
    const HeightMap& m = heightMap();
    const int c = std::min(static_cast<int>(u * m.width()), m.width() - 2);
    const int r = std::min(static_cast<int>(v * m.height()), m.height() - 2);
    const double bu = m.at(c + 1, r) - m.at(c, r);
    const double bv = m.at(c, r + 1) - m.at(c, r);
    const Vector3 pu{-n.z / ring, 0, n.x / ring};
    const Vector3 pv{n.x * n.y / ring, -ring, n.z * n.y / ring};
    return (n - pu * bu - pv * bv).normalised();
}

}  // namespace raytracer
