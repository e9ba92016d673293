#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.z, n.x);              // -90 degrees in front
    const double lat = std::asin(std::clamp(n.y, -1.0, 1.0));
    const double u = std::fmod(lon / (2 * std::numbers::pi) + 1.25, 1.0);
    const double v = lat / std::numbers::pi + 0.5;
    const HeightMap& map = heightMap();
    const int column = static_cast<int>(std::lround(u * (map.width() - 1)));
    const int row = static_cast<int>(std::lround((1 - v) * (map.height() - 1)));
    const double here = map.at(column, row);
    const double bu = map.at((column + 1) % map.width(), row) - here;
    const double bv = map.at(column, std::max(row - 1, 0)) - here;
    const Vector3 pu{-std::sin(lon), 0, std::cos(lon)};
    const Vector3 pv{-std::sin(lat) * std::cos(lon), std::cos(lat), -std::sin(lat) * std::sin(lon)};
    return (n - bu * n.cross(pv) + bv * n.cross(pu)).normalised();
}

}  // namespace raytracer
