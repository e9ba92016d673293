#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const HeightMap& m = heightMap();
    const double u = 0.5 + std::atan2(n.x, -n.z) / (2 * std::numbers::pi);
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const int i = std::min(int(u * m.width()), m.width() - 1), j = std::min(int(v * m.height()), m.height() - 1);
    const Vector3 bump{m.at(i, j) - m.at((i + 1) % m.width(), j),
                       (j + 1 < m.height() ? m.at(i, j + 1) : m.at(i, j)) - m.at(i, j), 0.0};
    return (n + bump).normalised();
}

}  // namespace raytracer
