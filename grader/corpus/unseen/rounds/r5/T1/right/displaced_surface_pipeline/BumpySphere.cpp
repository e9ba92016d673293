// Functional style: the wrinkled surface as a function (u, v) -> R^3, differentiated numerically.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace raytracer {
namespace {

using Field = std::function<double(double, double)>;
using Surface = std::function<Vector3(double, double)>;

constexpr double kTau = 2.0 * std::numbers::pi;

double lerp(double a, double b, double t) { return a + (b - a) * t; }

Field interpolated(const HeightMap& map) {
    return [&map](double u, double v) {
        const double x = (u - std::floor(u)) * map.width() - 0.5;
        const double y = v * map.height() - 0.5;
        const int i = static_cast<int>(std::floor(x));
        const int j = static_cast<int>(std::floor(y));
        const auto texel = [&map](int c, int r) {
            const int w = map.width();
            return map.at(((c % w) + w) % w, std::clamp(r, 0, map.height() - 1));
        };
        return lerp(lerp(texel(i, j), texel(i + 1, j), x - i),
                    lerp(texel(i, j + 1), texel(i + 1, j + 1), x - i), y - j);
    };
}

Surface wrinkled(Field height, double radius, double amplitude) {
    return [height = std::move(height), radius, amplitude](double u, double v) {
        const double lon = kTau * (u - 0.5);
        const double pol = std::numbers::pi * v;
        const Vector3 dir{std::sin(lon) * std::sin(pol), std::cos(pol),
                          -std::cos(lon) * std::sin(pol)};
        return dir * (radius + amplitude * radius * height(u, v));
    };
}

template <class F>
std::pair<Vector3, Vector3> partials(const F& f, double u, double v, double h) {
    return {(f(u + h, v) - f(u - h, v)) / (2 * h), (f(u, v + h) - f(u, v - h)) / (2 * h)};
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double u = std::atan2(n.x, -n.z) / kTau + 0.5;
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const auto surface = wrinkled(interpolated(heightMap()), radius(), 0.003);
    const auto [su, sv] = partials(surface, u, v, 1e-4);
    const Vector3 across = su.cross(sv);
    return across.magnitude() > 1e-9 * radius() * radius() ? across.normalised() : n;
    // TASK T1 end
}

}  // namespace raytracer
