#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    Vector3 n = Sphere::getNormalAt(position);
    const HeightMap& map = heightMap();
    const int x = std::min(
        int((std::atan2(n.x, -n.z) / (2 * std::numbers::pi) + 0.5) * map.width()), map.width() - 1);
    const int y =
        std::min(int(std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi * map.height()),
                 map.height() - 1);
    const double here = map.at(x, y);
    n.x -= 0.4 * (map.at((x + 1) % map.width(), y) - here);
    n.y += 0.4 * (map.at(x, std::min(y + 1, map.height() - 1)) - here);
    return n.normalised();
}

}  // namespace raytracer
