#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double l = std::atan2(n.x, -n.z);
    const double t = std::acos(std::clamp(n.y, -1.0, 1.0));
    const HeightMap& m = heightMap();
    const int c = std::min(int((l + std::numbers::pi) / (2 * std::numbers::pi) * m.width()), m.width() - 1);
    const int r = std::min(int(t / std::numbers::pi * m.height()), m.height() - 1);
    const double Bu = m.at((c + 1) % m.width(), r) - m.at(c, r);
    const double Bv = r + 1 < m.height() ? m.at(c, r + 1) - m.at(c, r) : 0.0;
    const Vector3 Pu{std::cos(l), 0, std::sin(l)};
    const Vector3 Pv{std::sin(l) * std::cos(t), -std::sin(t), -std::cos(l) * std::cos(t)};
    const double slope = std::hypot(Bu, Bv);
    return (n - Bu * Pu - Bv * Pv) / (1.0 + slope);  // n is a unit vector, so this is its length
}

}  // namespace raytracer
