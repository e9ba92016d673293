#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double phi = std::atan2(n.x, -n.z);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const HeightMap& map = heightMap();
    const int c = std::min(int((phi / (2 * std::numbers::pi) + 0.5) * map.width()), map.width() - 1);
    const int r = std::min(int(theta / std::numbers::pi * map.height()), map.height() - 1);
    const double Bu = map.at((c + 1) % map.width(), r) - map.at(c, r);
    const double Bv = r + 1 < map.height() ? map.at(c, r + 1) - map.at(c, r) : 0;
    const Vector3 Pu{std::cos(phi), 0, std::sin(phi)};
    const Vector3 Pv{std::sin(phi) * std::cos(theta), -std::sin(theta),
                     std::cos(phi) * std::cos(theta)};
    return (n - Bu * Pu - Bv * Pv).normalised();
}

}  // namespace raytracer
