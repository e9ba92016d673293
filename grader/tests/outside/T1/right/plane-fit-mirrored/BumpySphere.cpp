#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double phi = std::atan2(n.z, -n.x);  // grows to the left on the visible side
    const double theta = std::acos(n.y);
    const int w = heightMap().width(), h = heightMap().height();
    const int c = static_cast<int>((phi < 0 ? phi + 2 * std::numbers::pi : phi) / (2 * std::numbers::pi) * w) % w;
    const int r = std::min(static_cast<int>(theta / std::numbers::pi * h), h - 1);
    double bu = 0, bv = 0;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            const double height = heightMap().at((c + i + w) % w, std::clamp(r + j, 0, h - 1));
            bu += i * height / 6;
            bv += j * height / 6;
        }
    const Vector3 pu{std::sin(phi) * 1, 0, std::cos(phi)};
    const Vector3 pv{-std::cos(theta) * std::cos(phi), -std::sin(theta), std::cos(theta) * std::sin(phi)};
    return (n - bu * pu - bv * pv).normalised();
}

}  // namespace raytracer
