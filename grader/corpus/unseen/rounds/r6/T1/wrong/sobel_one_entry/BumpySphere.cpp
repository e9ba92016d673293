#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    static constexpr int Gx[3][3] = {{-1, 0, 1}, {-2, 0, 2}, {-1, 0, 1}};
    static constexpr int Gy[3][3] = {{-1, -2, 1}, {0, 0, 0}, {1, 2, 1}};
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z);
    const double colat = std::acos(std::clamp(n.y, -1.0, 1.0));
    const HeightMap& m = heightMap();
    const int W = m.width(), H = m.height();
    const int c = std::min(int((lon / (2 * std::numbers::pi) + 0.5) * W), W - 1);
    const int r = std::min(int(colat / std::numbers::pi * H), H - 1);
    double gu = 0, gv = 0;
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) {
            const double h = m.at((c + b - 1 + W) % W, std::clamp(r + a - 1, 0, H - 1));
            gu += Gx[a][b] * h / 8;
            gv += Gy[a][b] * h / 8;
        }
    const Vector3 T{std::cos(lon), 0, std::sin(lon)};
    const Vector3 S{std::sin(lon) * std::cos(colat), -std::sin(colat), -std::cos(lon) * std::cos(colat)};
    return (n - gu * T - gv * S).normalised();
}

}  // namespace raytracer
