#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    constexpr double kStrength = 0.3;
    const Vector3 n = Sphere::getNormalAt(position);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double phi = std::atan2(n.z, n.x);
    const auto& map = heightMap();
    const double u = (phi + std::numbers::pi) / (2 * std::numbers::pi);
    const double v = theta / std::numbers::pi;
    const int x = static_cast<int>(u * map.width()) % map.width();
    const int y = std::min(static_cast<int>(v * map.height()), map.height() - 1);
    const double b = map.at(x, y);
    const double du = map.at((x + 1) % map.width(), y) - b;
    const double dv = (y + 1 < map.height() ? map.at(x, y + 1) : b) - b;
    // the normal of a slope that rises towards +phi looks like the normal of a smaller phi
    const double t2 = theta - kStrength * dv;
    const double p2 = phi - kStrength * du;
    return {std::sin(t2) * std::cos(p2), std::cos(t2), std::sin(t2) * std::sin(p2)};
    // TASK T1 end
}
}  // namespace raytracer
