#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const Vector3 Pu{std::cos(lambda), 0, std::sin(lambda)};
    const Vector3 Pv = n.cross(Pu);
    const HeightMap& m = heightMap();
    const double v = theta / std::numbers::pi;
    const int i = std::min(int((lambda / (2 * std::numbers::pi) + 0.5) * m.width()), m.width() - 1);
    const int j = std::min(int(v * m.height()), m.height() - 1);
    const int right = (i + 1) % m.width();
    const int below = std::min(j + 1, m.height() - 1);
    const auto sign = [](double d) { return d > 0 ? 0.5 : d < 0 ? -0.5 : 0.0; };
    const double Bu = sign(m.at(right, j) - m.at(i, j));
    const double Bv = sign(m.at(i, below) - m.at(i, j));
    return (n - Bu * Pu - Bv * Pv).normalised();
}

}  // namespace raytracer
