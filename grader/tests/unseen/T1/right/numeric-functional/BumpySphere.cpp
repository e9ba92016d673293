#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace raytracer {
namespace {
using Function = std::function<double(double, double)>;

Function byU(const Function& f, double h) {
    return [f, h](double u, double v) { return (f(u + h, v) - f(u - h, v)) / (2 * h); };
}
Function byV(const Function& f, double h) {
    return [f, h](double u, double v) { return (f(u, v + h) - f(u, v - h)) / (2 * h); };
}
const double pi = std::numbers::pi;
// Equation (2)'s three functions
const std::array<Function, 3> F{
    [](double u, double v) { return std::sin(2 * pi * u) * std::sin(pi * v); },
    [](double, double v) { return std::cos(pi * v); },
    [](double u, double v) { return -std::cos(2 * pi * u) * std::sin(pi * v); }};
}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double u = std::atan2(n.x, -n.z) / (2 * pi);
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / pi;
    const HeightMap& m = heightMap();
    const Function B = [&m](double s, double t) {
        const double x = (s - std::floor(s)) * m.width();
        const double y = std::clamp(t, 0.0, 1.0) * m.height();
        return m.at(std::min(static_cast<int>(x), m.width() - 1),
                    std::min(static_cast<int>(y), m.height() - 1));
    };
    const double e = 1e-5;
    Vector3 Pu{byU(F[0], e)(u, v), byU(F[1], e)(u, v), byU(F[2], e)(u, v)};
    Vector3 Pv{byV(F[0], e)(u, v), byV(F[1], e)(u, v), byV(F[2], e)(u, v)};
    if (Pu.magnitude() > 1e-9) Pu = Pu.normalised();
    Pv = Pv.normalised();
    const double Bu = byU(B, 1.0 / m.width())(u, v) / 100.0;
    const double Bv = byV(B, 1.0 / m.height())(u, v) / 100.0;
    const double h = Pu.cross(Pv).dot(n) >= 0 ? 1 : -1;
    return (n + h * Bu * n.cross(Pv) - h * Bv * n.cross(Pu)).normalised();
}
}  // namespace raytracer
