#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const int size = heightMap().width();
    const double u = std::atan2(n.x, -n.z) / (2 * std::numbers::pi) + 0.5;
    const double v = 0.5 - std::asin(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const auto B = [&](int x, int y) {
        return heightMap().at((x + size) % size, std::clamp(y, 0, heightMap().height() - 1));
    };
    const int x = static_cast<int>(u * size), y = static_cast<int>(v * size);
    Vector3 Pu = Vector3{-n.z, 0, n.x};
    Pu = Pu.magnitude() > 0 ? Pu.normalised() : Vector3{1, 0, 0};
    return (n - (B(x + 1, y) - B(x, y)) * Pu - (B(x, y + 1) - B(x, y)) * n.cross(Pu)).normalised();
}

}  // namespace raytracer
