#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double sinT = std::sqrt(n.x * n.x + n.z * n.z);
    const double cosT = std::sqrt(std::max(0.0, 1.0 - sinT * sinT));
    const double lambda = std::atan2(n.x, -n.z);
    const Vector3 Pu{std::cos(lambda), 0, std::sin(lambda)};
    const Vector3 Pv{std::sin(lambda) * cosT, -sinT, -std::cos(lambda) * cosT};
    const HeightMap& m = heightMap();
    const int i = std::min(int((lambda / (2 * std::numbers::pi) + 0.5) * m.width()), m.width() - 1);
    const int j = std::min(
        int(std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi * m.height()), m.height() - 1);
    const double Bu = m.at((i + 1) % m.width(), j) - m.at(i, j);
    const double Bv = m.at(i, std::min(j + 1, m.height() - 1)) - m.at(i, j);
    return (n - Bu * Pu - Bv * Pv).normalised();
}

}  // namespace raytracer
