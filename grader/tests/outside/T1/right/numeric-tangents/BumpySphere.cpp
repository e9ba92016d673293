#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {
Vector3 F(double u, double v) {
    const double a = 2 * std::numbers::pi * u, b = std::numbers::pi * v;
    return {std::sin(b) * std::cos(a), std::cos(b), std::sin(b) * std::sin(a)};
}
double B(const HeightMap& m, double u, double v) {
    const double x = u * m.width() - 0.5, y = v * m.height() - 0.5;
    const double fx = x - std::floor(x), fy = y - std::floor(y);
    auto h = [&m](double i, double j) {
        int c = static_cast<int>(i) % m.width();
        if (c < 0) c += m.width();
        return m.at(c, std::clamp(static_cast<int>(j), 0, m.height() - 1));
    };
    const double i = std::floor(x), j = std::floor(y);
    return (1 - fy) * ((1 - fx) * h(i, j) + fx * h(i + 1, j)) + fy * ((1 - fx) * h(i, j + 1) + fx * h(i + 1, j + 1));
}
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double u = std::atan2(n.z, n.x) / (2 * std::numbers::pi), v = std::acos(n.y) / std::numbers::pi;
    const double e = 1e-4;
    const Vector3 pu = (F(u + e, v) - F(u - e, v)).normalised();
    const Vector3 pv = (F(u, v + e) - F(u, v - e)).normalised();
    const double du = 0.5 / heightMap().width(), dv = 0.5 / heightMap().height();
    const double bu = B(heightMap(), u + du, v) - B(heightMap(), u - du, v);
    const double bv = B(heightMap(), u, v + dv) - B(heightMap(), u, v - dv);
    const Vector3 bumped = n - pu * bu - pv * bv;
    return std::isfinite(bumped.x) ? bumped.normalised() : n;
}

}  // namespace raytracer
