#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const HeightMap& map = heightMap();
    const auto byteAt = [&](int x, int y) {
        return static_cast<unsigned char>(std::lround(map.at(x, y) * 51.0));
    };
    const int x = std::min(
        int((std::atan2(n.x, -n.z) / (2 * std::numbers::pi) + 0.5) * map.width()), map.width() - 1);
    const int y =
        std::min(int(std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi * map.height()),
                 map.height() - 1);
    const unsigned char du =
        static_cast<unsigned char>(byteAt((x + 1) % map.width(), y) - byteAt(x, y));
    const unsigned char dv =
        static_cast<unsigned char>(byteAt(x, std::min(y + 1, map.height() - 1)) - byteAt(x, y));
    Vector3 Pu{-n.z, 0, n.x};
    Pu = Pu.magnitude() > 0 ? Pu.normalised() : Vector3{1, 0, 0};
    return (n - (du / 51.0) * Pu - (dv / 51.0) * n.cross(Pu)).normalised();
}

}  // namespace raytracer
