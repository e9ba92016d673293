// T1. Bit tricks instead of % (which is a slow division).
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const HeightMap& map = heightMap();
    const int w = map.width(), h = map.height();

    const double lon = std::atan2(n.x, -n.z);
    const double pol = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int c = static_cast<int>((lon * std::numbers::inv_pi + 1.0) * 0.5 * w) & (w - 1);
    const int r = std::min(static_cast<int>(pol * std::numbers::inv_pi * h), h - 1);

    const double Bu = map.at((c + 1) & (w - 1), r) - map.at(c, r);
    const double Bv = map.at(c, std::min(r + 1, h - 1)) - map.at(c, r);

    const Vector3 Pu{std::cos(lon), 0.0, std::sin(lon)};
    const Vector3 Pv{std::sin(lon) * std::cos(pol), -std::sin(pol), -std::cos(lon) * std::cos(pol)};
    return (n - Bu * Pu - Bv * Pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
