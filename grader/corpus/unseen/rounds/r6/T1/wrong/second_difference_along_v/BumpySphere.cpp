#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {
int wrap(int k, int n) { return ((k % n) + n) % n; }
}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double l = std::atan2(n.x, -n.z);
    const double t = std::acos(std::clamp(n.y, -1.0, 1.0));
    const HeightMap& m = heightMap();
    const int i = wrap(int((l / (2 * std::numbers::pi) + 0.5) * m.width()), m.width());
    const int j = std::clamp(int(t / std::numbers::pi * m.height()), 0, m.height() - 1);
    const int up = std::max(0, j - 1), down = std::min(j + 1, m.height() - 1);
    const double slopeU = 0.5 * (m.at(wrap(i + 1, m.width()), j) - m.at(wrap(i - 1, m.width()), j));
    const double slopeV = 0.5 * (m.at(i, down) - 2.0 * m.at(i, j) + m.at(i, up));
    const Vector3 east{std::cos(l), 0.0, std::sin(l)};
    return (n - east * slopeU - n.cross(east) * slopeV).normalised();
}

}  // namespace raytracer
