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
    const int degrees = static_cast<int>(lambda * 180 / std::numbers::pi) + 180;
    const int down = static_cast<int>(theta * 180 / std::numbers::pi);
    const int i = std::min(degrees * m.width() / 360, m.width() - 1);
    const int j = std::min(down * m.height() / 180, m.height() - 1);
    const int right = (i + 1) % m.width();
    const int below = std::min(j + 1, m.height() - 1);
    const double Bu = m.at(right, j) - m.at(i, j);
    const double Bv = m.at(i, below) - m.at(i, j);
    return (n - Bu * Pu - Bv * Pv).normalised();
}

}  // namespace raytracer
