#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z);
    const double lat = std::asin(std::clamp(n.y, -1.0, 1.0));
    const double u = 0.5 + lon / (2.0 * std::numbers::pi);
    const double v = 0.5 + lat / std::numbers::pi;

    const int w = heightMap().width();
    const int h = heightMap().height();
    const int x = std::min(w - 1, static_cast<int>(u * w));
    const int y = std::min(h - 1, static_cast<int>(v * h));
    const double du = heightMap().at((x + 1) % w, y) - heightMap().at(x, y);
    const double dv = heightMap().at(x, std::min(h - 1, y + 1)) - heightMap().at(x, y);

    const Vector3 east{std::cos(lon), 0.0, std::sin(lon)};
    const Vector3 north{-std::sin(lon) * std::sin(lat), std::cos(lat), std::cos(lon) * std::sin(lat)};
    return (n - east * du - north * dv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
