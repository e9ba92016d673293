#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

/// a + b e with e * e = 0: b is the derivative.
struct Dual {
    double a = 0, b = 0;
};
Dual operator*(Dual p, Dual q) { return {p.a * q.a, p.a * q.b + p.b * q.a}; }
Dual operator-(Dual p) { return {-p.a, -p.b}; }
Dual sin(Dual p) { return {std::sin(p.a), p.b * std::cos(p.a)}; }
Dual cos(Dual p) { return {std::cos(p.a), -p.b * std::sin(p.a)}; }

Vector3 derivative(Dual l, Dual t) {
    const Dual x = sin(l) * sin(t), y = cos(t), z = -(cos(l) * sin(t));
    return {x.b, y.b, z.b};
}

Vector3 unitOr(const Vector3& v, const Vector3& fallback) {
    const double m = v.magnitude();
    return m > 1e-12 ? v / m : fallback;
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double l = std::atan2(n.x, -n.z);
    const double t = std::acos(std::min(1.0, std::max(-1.0, n.y)));
    const Vector3 Pu = unitOr(derivative({l, 1}, {t, 0}), {std::cos(l), 0, std::sin(l)});
    const Vector3 Pv = unitOr(derivative({l, 0}, {t, 1}), {0, 0, 0});

    const HeightMap& B = heightMap();
    const int columns = B.width(), rows = B.height();
    const auto column = std::min<int>(columns - 1, int((l + std::numbers::pi) * columns /
                                                       (2 * std::numbers::pi)));
    const auto row = std::min<int>(rows - 1, int(t * rows / std::numbers::pi));
    const auto slope = [&](int dc, int dr) {
        if (row + dr >= rows) return 0.0;
        return B.at((column + dc) % columns, row + dr) - B.at(column, row);
    };
    return (n - slope(1, 0) * Pu - slope(0, 1) * Pv).normalised();
}

}  // namespace raytracer
