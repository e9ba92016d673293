#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

// Rodrigues' formula
static Vector3 rotated(const Vector3& v, const Vector3& k, double angle) {
    return v * std::cos(angle) + k.cross(v) * std::sin(angle) + k * (k.dot(v) * (1 - std::cos(angle)));
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z), pol = std::acos(std::clamp(n.y, -1.0, 1.0));
    const HeightMap& m = heightMap();
    const int i = std::min(int((lon / std::numbers::pi + 1) * 0.5 * m.width()), m.width() - 1);
    const int j = std::min(int(pol / std::numbers::pi * m.height()), m.height() - 1);
    const double bu = m.at((i + 1) % m.width(), j) - m.at(i, j);
    const double bv = j + 1 < m.height() ? m.at(i, j + 1) - m.at(i, j) : 0.0;
    const Vector3 east{std::cos(lon), 0, std::sin(lon)};
    const Vector3 up = east * bu + n.cross(east) * bv;   // up the slope
    const double slope = up.magnitude();
    if (slope == 0.0) return n;
    return rotated(n, up.cross(n) / slope, slope).normalised();
}

}  // namespace raytracer
