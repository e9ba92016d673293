#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const HeightMap& map = heightMap();
    const int x = std::min(
        int((std::atan2(n.x, -n.z) / (2 * std::numbers::pi) + 0.5) * map.width()), map.width() - 1);
    const int y =
        std::min(int(std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi * map.height()),
                 map.height() - 1);
    const int here = static_cast<int>(map.at(x, y));
    const int right = static_cast<int>(map.at((x + 1) % map.width(), y));
    const int below = static_cast<int>(map.at(x, std::min(y + 1, map.height() - 1)));
    Vector3 Pu{-n.z, 0, n.x};
    Pu = Pu.magnitude() > 0 ? Pu.normalised() : Vector3{1, 0, 0};
    return (n - (right - here) * Pu - (below - here) * n.cross(Pu)).normalised();
}

}  // namespace raytracer
