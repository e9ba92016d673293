#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const Vector3 up{0.0, 1.0, 0.0};
    const Vector3 right = n.cross(up).normalised();
    const Vector3 down = n.cross(right).normalised();

    const double u = std::atan2(n.x, -n.z) / (2.0 * std::numbers::pi) + 0.5;
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const HeightMap& map = heightMap();
    const int col = std::min(static_cast<int>(u * map.width()), map.width() - 1);
    const int row = std::min(static_cast<int>(v * map.height()), map.height() - 1);
    const double here = map.at(col, row);
    const double bu = map.at((col + 1) % map.width(), row) - here;
    const double bv = row + 1 < map.height() ? map.at(col, row + 1) - here : 0.0;
    return (n - bu * right - bv * down).normalised();
    // TASK T1 end
}

}  // namespace raytracer
