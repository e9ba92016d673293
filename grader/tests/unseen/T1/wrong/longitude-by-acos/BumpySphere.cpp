#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double lambda = std::acos(std::clamp(-n.z / std::max(1e-12, std::sin(theta)), -1.0, 1.0));
    const Vector3 Pu{std::cos(lambda), 0, std::sin(lambda)};
    const Vector3 Pv{std::sin(lambda) * std::cos(theta), -std::sin(theta),
                     -std::cos(lambda) * std::cos(theta)};
    const HeightMap& m = heightMap();
    const int i = std::min(int((lambda / (2 * std::numbers::pi) + 0.5) * m.width()), m.width() - 1);
    const int j = std::min(int(theta / std::numbers::pi * m.height()), m.height() - 1);
    const double Bu = m.at((i + 1) % m.width(), j) - m.at(i, j);
    const double Bv = m.at(i, std::min(j + 1, m.height() - 1)) - m.at(i, j);
    return (n - Bu * Pu - Bv * Pv).normalised();
}

}  // namespace raytracer
