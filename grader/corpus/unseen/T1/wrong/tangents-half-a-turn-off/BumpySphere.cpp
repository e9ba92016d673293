// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const HeightMap& map = heightMap();
    const Vector3 n = Sphere::getNormalAt(position);
    const double u = 0.5 + std::atan2(n.x, -n.z) / (2.0 * std::numbers::pi);
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;

    const double lon = 2.0 * std::numbers::pi * u, lat = std::numbers::pi * v;
    const Vector3 Pu{std::cos(lon), 0.0, std::sin(lon)};
    const Vector3 Pv{std::sin(lon) * std::cos(lat), -std::sin(lat), -std::cos(lon) * std::cos(lat)};

    const int x = std::min(static_cast<int>(u * map.width()), map.width() - 1);
    const int y = std::min(static_cast<int>(v * map.height()), map.height() - 1);
    const double slopeX = map.at((x + 1) % map.width(), y) - map.at(x, y);
    const double slopeY = map.at(x, std::min(y + 1, map.height() - 1)) - map.at(x, y);
    return (n + n.cross(Pv) * slopeX - n.cross(Pu) * slopeY).normalised();
    // TASK T1 end
}

}  // namespace raytracer
