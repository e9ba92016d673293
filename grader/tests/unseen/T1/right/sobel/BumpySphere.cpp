#include <raytracer/geometry/BumpySphere.h>
#include <array>
#include <cmath>
#include <numbers>

namespace raytracer {
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const HeightMap& map = heightMap();
    const int w = map.width(), h = map.height();
    const int cx = static_cast<int>((std::atan2(n.x, -n.z) / std::numbers::pi + 1.0) * 0.5 * w) % w;
    const int cy = std::min(
        h - 1, static_cast<int>(
                   (0.5 - std::asin(std::max(-1.0, std::min(1.0, n.y))) / std::numbers::pi) * h));
    // Sobel, as in the image processing course
    constexpr std::array<int, 3> smooth{1, 2, 1}, slope{-1, 0, 1};
    double gx = 0, gy = 0;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            const int x = (cx + i + w) % w;
            const int y = std::max(0, std::min(h - 1, cy + j));
            const double b = map.at(x, y);
            gx += b * slope[static_cast<std::size_t>(i + 1)] *
                  smooth[static_cast<std::size_t>(j + 1)];
            gy += b * smooth[static_cast<std::size_t>(i + 1)] *
                  slope[static_cast<std::size_t>(j + 1)];
        }
    gx /= 8.0;
    gy /= 8.0;
    Vector3 pu{-n.z, 0.0, n.x};
    pu = pu.magnitude() > 1e-12 ? pu.normalised() : Vector3{1, 0, 0};
    const Vector3 pv = n.cross(pu);
    return (n - gx * pu - gy * pv).normalised();
}
}  // namespace raytracer
