#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 N = Sphere::getNormalAt(position);
    const double az = std::atan2(N.z, N.x) + std::numbers::pi;
    const double pol = std::acos(std::clamp(N.y, -1.0, 1.0));
    const double ca = -std::cos(az), sa = -std::sin(az);   // az was shifted by pi
    // P = (cos(az) sin(pol), cos(pol), sin(az) sin(pol))
    const Vector3 Pu = Vector3{-sa, 0.0, ca} * std::cos(pol);
    const Vector3 Pv{ca * std::cos(pol), -std::sin(pol), sa * std::cos(pol)};

    const auto& m = heightMap();
    const int x = int(az / (2 * std::numbers::pi) * m.width()) % m.width();
    const int y = std::min(int(pol / std::numbers::pi * m.height()), m.height() - 1);
    const double du = m.at((x + 1) % m.width(), y) - m.at(x, y);
    const double dv = m.at(x, std::min(y + 1, m.height() - 1)) - m.at(x, y);
    Vector3 result = N;
    result -= du * Pu;
    result -= dv * Pv;
    return result.normalised();
}

}  // namespace raytracer
