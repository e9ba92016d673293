#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

/// Quadratic B-spline around texel centres: three weights and their derivatives.
struct Spline {
    int first;
    double w[3], dw[3];
    explicit Spline(double x) {  // in texels, centre of texel k at k + 1/2
        const double k = std::floor(x);
        const double f = x - k - 0.5;  // -1/2 .. 1/2
        first = static_cast<int>(k) - 1;
        w[0] = 0.5 * (0.5 - f) * (0.5 - f);
        w[1] = 0.75 - f * f;
        w[2] = 0.5 * (0.5 + f) * (0.5 + f);
        dw[0] = f - 0.5;
        dw[1] = -2.0 * f;
        dw[2] = f + 0.5;
    }
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double l = std::atan2(n.x, -n.z), t = std::acos(std::clamp(n.y, -1.0, 1.0));
    const HeightMap& map = heightMap();
    const Spline su((l / (2 * std::numbers::pi) + 0.5) * map.width());
    const Spline sv(t / std::numbers::pi * map.height());

    double bu = 0, bv = 0;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
            const int c = (su.first + i + map.width()) % map.width();
            const int r = std::clamp(sv.first + j, 0, map.height() - 1);
            const double b = map.at(c, r);
            bu += su.dw[i] * sv.w[j] * b;
            bv += su.w[i] * sv.dw[j] * b;
        }
    const Vector3 east{std::cos(l), 0, std::sin(l)};
    const Vector3 south = n.cross(east);  // n x Pu = Pv, as Pu x Pv = n
    return (n - bu * east - bv * south).normalised();
}

}  // namespace raytracer
