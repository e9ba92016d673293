// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const Vector3 c = centre();
    const double longitude = std::atan2(position.x, c.z - position.z);
    const double polar = std::acos(std::clamp((position.y - c.y) / radius(), -1.0, 1.0));
    const HeightMap& m = heightMap();
    const double u = longitude / (2.0 * std::numbers::pi) + 0.5;
    const double v = polar / std::numbers::pi;
    const int x = std::min(static_cast<int>(u * m.width()), m.width() - 1);
    const int y = std::min(static_cast<int>(v * m.height()), m.height() - 1);
    const Vector3 Pu{std::cos(longitude), 0.0, std::sin(longitude)};
    const Vector3 Pv{std::sin(longitude) * std::cos(polar), -std::sin(polar), -std::cos(longitude) * std::cos(polar)};
    const double Bu = m.at((x + 1) % m.width(), y) - m.at(x, y);
    const double Bv = m.at(x, std::min(y + 1, m.height() - 1)) - m.at(x, y);
    return (n + Bu * n.cross(Pv) - Bv * n.cross(Pu)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
