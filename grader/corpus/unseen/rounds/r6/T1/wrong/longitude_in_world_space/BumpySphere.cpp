#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    double lon = std::atan2(position.x, -position.z);
    if (lon < 0) lon += 2 * std::numbers::pi;
    const double colat = std::acos(std::clamp(n.y, -1.0, 1.0));
    const HeightMap& h = heightMap();
    const int i = int(lon / (2 * std::numbers::pi) * h.width()) % h.width();
    const int j = std::min(int(colat / std::numbers::pi * h.height()), h.height() - 1);
    const double dx = h.at((i + 1) % h.width(), j) - h.at(i, j);
    const double dy = j + 1 < h.height() ? h.at(i, j + 1) - h.at(i, j) : 0.0;
    const double rho = std::max(std::hypot(n.x, n.z), 1e-12);
    const Vector3 east{-n.z / rho, 0, n.x / rho};
    const Vector3 south = n.cross(east);
    return (n - dx * east - dy * south).normalised();
}

}  // namespace raytracer
