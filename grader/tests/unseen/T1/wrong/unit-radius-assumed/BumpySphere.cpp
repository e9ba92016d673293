#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const Vector3 d = position - centre();
    const double lambda = std::atan2(d.x, -d.z), theta = std::acos(std::clamp(d.y, -1.0, 1.0));
    Vector3 Pu{-n.z, 0, n.x};
    Pu = Pu.magnitude() > 0 ? Pu.normalised() : Vector3{1, 0, 0};
    const Vector3 Pv = n.cross(Pu);
    const HeightMap& m = heightMap();
    const int i = std::min(int((lambda / (2 * std::numbers::pi) + 0.5) * m.width()), m.width() - 1);
    const int j = std::min(int(theta / std::numbers::pi * m.height()), m.height() - 1);
    const double Bu = m.at((i + 1) % m.width(), j) - m.at(i, j);
    const double Bv = m.at(i, std::min(j + 1, m.height() - 1)) - m.at(i, j);
    return (n - Bu * Pu - Bv * Pv).normalised();
}

}  // namespace raytracer
