#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double l = std::atan2(n.x, -n.z);
    const double t = std::acos(std::clamp(n.y, -1.0, 1.0));
    const HeightMap& map = heightMap();
    int col = std::min(int((l / (2 * std::numbers::pi) + 0.5) * map.width()), map.width() - 1);
    int row = std::min(int(t / std::numbers::pi * map.height()), map.height() - 1);
    const double here = map.at(col, row);
    col = (col + 1) % map.width();
    const double Bu = map.at(col, row) - here;
    row = std::min(row + 1, map.height() - 1);
    const double Bv = map.at(col, row) - here;
    const Vector3 Pu{std::cos(l), 0.0, std::sin(l)};
    const Vector3 Pv{std::sin(l) * std::cos(t), -std::sin(t), -std::cos(l) * std::cos(t)};
    return (n + Bu * n.cross(Pv) - Bv * n.cross(Pu)).normalised();
}

}  // namespace raytracer
