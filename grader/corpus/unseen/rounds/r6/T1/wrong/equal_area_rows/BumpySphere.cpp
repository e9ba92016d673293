#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double u = std::atan2(n.x, -n.z) / (2 * std::numbers::pi) + 0.5;
    const double v = (1.0 - n.y) / 2.0;      // area-preserving, no acos needed
    const HeightMap& hm = heightMap();
    const int i = std::min(static_cast<int>(u * hm.width()), hm.width() - 1);
    const int j = std::clamp(static_cast<int>(v * hm.height()), 0, hm.height() - 1);
    const double du = hm.at((i + 1) % hm.width(), j) - hm.at(i, j);
    const double dv = j + 1 < hm.height() ? hm.at(i, j + 1) - hm.at(i, j) : 0.0;
    const double rho = std::max(1e-12, std::hypot(n.x, n.z));
    const Vector3 Pu{-n.z / rho, 0, n.x / rho};
    const Vector3 Pv = n.cross(Pu);
    return (n - du * Pu - dv * Pv).normalised();
}

}  // namespace raytracer
