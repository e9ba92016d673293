#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const Vector3 d = position - centre();
    const double phi = std::atan2(d.x, -d.z);
    const double theta = std::acos(std::clamp(d.y, -1.0, 1.0));
    const HeightMap& map = heightMap();
    const int a = std::min(int((phi + std::numbers::pi) / (2 * std::numbers::pi) * map.width()), map.width() - 1);
    const int b = std::min(int(theta / std::numbers::pi * map.height()), map.height() - 1);
    const double p = map.at((a + 1) % map.width(), b) - map.at(a, b);
    const double q = b < map.height() - 1 ? map.at(a, b + 1) - map.at(a, b) : 0.0;
    const double s = std::max(std::hypot(n.x, n.z), 1e-12);
    const Vector3 e{-n.z / s, 0.0, n.x / s};
    const Vector3 f{n.x * n.y / s, -s, n.z * n.y / s};
    return (n - p * e - q * f).normalised();
}

}  // namespace raytracer
