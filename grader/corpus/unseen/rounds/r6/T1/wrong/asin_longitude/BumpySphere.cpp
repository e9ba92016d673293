#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double s = std::max(std::sin(theta), 1e-12);
    const double phi = std::asin(std::clamp(n.x / s, -1.0, 1.0));
    const double u = 0.5 + phi / (2 * std::numbers::pi), v = theta / std::numbers::pi;
    const HeightMap& map = heightMap();
    const int i = std::min(int(u * map.width()), map.width() - 1);
    const int j = std::min(int(v * map.height()), map.height() - 1);
    const double Bu = map.at((i + 1) % map.width(), j) - map.at(i, j);
    const double Bv = j + 1 < map.height() ? map.at(i, j + 1) - map.at(i, j) : 0.0;
    const Vector3 Pu{-n.z / s, 0, n.x / s};
    const Vector3 Pv{n.x / s * n.y, -s, n.z / s * n.y};
    return (n - Bu * Pu - Bv * Pv).normalised();
}

}  // namespace raytracer
