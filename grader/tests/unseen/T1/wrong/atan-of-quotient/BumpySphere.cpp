#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = n.z == 0.0 ? std::numbers::pi / 2 : std::atan(n.x / -n.z);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const Vector3 right{std::cos(lambda), 0.0, std::sin(lambda)};
    const Vector3 down = n.cross(right);
    const HeightMap& m = heightMap();
    const int i = std::clamp(int((lambda / std::numbers::pi + 0.5) * m.width()), 0, m.width() - 1);
    const int j = std::min(int(theta / std::numbers::pi * m.height()), m.height() - 1);
    const double du = m.at((i + 1) % m.width(), j) - m.at(i, j);
    const double dv = m.at(i, std::min(j + 1, m.height() - 1)) - m.at(i, j);
    return (n - right * du - down * dv).normalised();
}

}  // namespace raytracer
