#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    constexpr double kDelta = 1e-4;
    const Vector3 n = Sphere::getNormalAt(position);
    const double phi = std::atan2(n.x, -n.z);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));

    const auto height = [&map = heightMap()](double u, double v) {
        const int c = static_cast<int>((u - std::floor(u)) * map.width());
        const int r = static_cast<int>(v * map.height());
        return map.at(std::clamp(c, 0, map.width() - 1), std::clamp(r, 0, map.height() - 1));
    };
    const double u = phi / (2 * std::numbers::pi) + 0.5, v = theta / std::numbers::pi;
    // Numerical derivatives, scaled to one texel.
    const double bu = (height(u + kDelta, v) - height(u, v)) / (kDelta * heightMap().width());
    const double bv = (height(u, v + kDelta) - height(u, v)) / (kDelta * heightMap().height());

    const Vector3 pu{std::cos(phi), 0.0, std::sin(phi)};
    const Vector3 pv{std::sin(phi) * std::cos(theta), -std::sin(theta), -std::cos(phi) * std::cos(theta)};
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
