#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {
double w(double t, int k) {
    switch (k) {
        case 0:
            return ((-0.5 * t + 1.0) * t - 0.5) * t;
        case 1:
            return (1.5 * t - 2.5) * t * t + 1.0;
        case 2:
            return ((-1.5 * t + 2.0) * t + 0.5) * t;
        default:
            return (0.5 * t - 0.5) * t * t;
    }
}
double dw(double t, int k) {
    switch (k) {
        case 0:
            return (-1.5 * t + 2.0) * t - 0.5;
        case 1:
            return (4.5 * t - 5.0) * t;
        case 2:
            return (-4.5 * t + 4.0) * t + 0.5;
        default:
            return (1.5 * t - 1.0) * t;
    }
}
}  // namespace
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const HeightMap& m = heightMap();
    const double x = (std::atan2(n.x, -n.z) / (2 * std::numbers::pi) + 0.5) * m.width() - 0.5;
    const double y = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi * m.height() - 0.5;
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    double bu = 0, bv = 0;
    for (int b = 0; b < 4; ++b)
        for (int a = 0; a < 4; ++a) {
            const double h = m.at((i + a - 1 + 2 * m.width()) % m.width(),
                                  std::clamp(j + b - 1, 0, m.height() - 1));
            bu += h * dw(x - i, a) * w(y - j, b);
            bv += h * w(x - i, a) * dw(y - j, b);
        }
    Vector3 right{-n.z, 0, n.x};
    right = right.magnitude() > 1e-9 ? right.normalised() : Vector3{1, 0, 0};
    return (n - right * bu - n.cross(right) * bv).normalised();
}

}  // namespace raytracer
