// Forward-mode automatic differentiation of the displaced sphere
//     S(u, v) = (r + k h(u, v)) * d(u, v),
// whose normal is dS/du x dS/dv. Heights are interpolated bilinearly.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace raytracer {
namespace {

/// A value together with its partial derivatives by N variables.
template <std::size_t N>
struct Dual {
    double value = 0.0;
    std::array<double, N> d{};

    static constexpr Dual variable(double v, std::size_t which) {
        Dual r{v, {}};
        r.d[which] = 1.0;
        return r;
    }

    template <typename F>
    constexpr Dual chain(F derivative, double newValue) const {
        Dual r{newValue, {}};
        for (std::size_t i = 0; i < N; ++i) r.d[i] = derivative * d[i];
        return r;
    }

    friend constexpr Dual operator*(const Dual& a, const Dual& b) {
        Dual r{a.value * b.value, {}};
        for (std::size_t i = 0; i < N; ++i) r.d[i] = a.d[i] * b.value + a.value * b.d[i];
        return r;
    }
    friend constexpr Dual operator*(double s, const Dual& a) { return a.chain(s, s * a.value); }
    friend constexpr Dual operator+(double s, Dual a) {
        a.value += s;
        return a;
    }
    friend Dual sin(const Dual& a) { return a.chain(std::cos(a.value), std::sin(a.value)); }
    friend Dual cos(const Dual& a) { return a.chain(-std::sin(a.value), std::cos(a.value)); }
};

using UV = Dual<2>;

/// Bilinear height; texel centres lie at half-integers.
UV heightAt(const HeightMap& map, const UV& u, const UV& v) {
    const int w = map.width();
    const int h = map.height();
    const double x = u.value * w - 0.5;
    const double y = v.value * h - 0.5;
    const int x0 = static_cast<int>(std::floor(x));
    const int y0 = static_cast<int>(std::floor(y));
    const double fx = x - x0;
    const double fy = y - y0;
    const auto texel = [&](int c, int r) {
        return map.at(((c % w) + w) % w, std::clamp(r, 0, h - 1));
    };
    const double b00 = texel(x0, y0), b10 = texel(x0 + 1, y0);
    const double b01 = texel(x0, y0 + 1), b11 = texel(x0 + 1, y0 + 1);
    UV result;
    result.value = std::lerp(std::lerp(b00, b10, fx), std::lerp(b01, b11, fx), fy);
    const double byU = w * std::lerp(b10 - b00, b11 - b01, fy);
    const double byV = h * std::lerp(b01 - b00, b11 - b10, fx);
    for (std::size_t i = 0; i < 2; ++i) result.d[i] = byU * u.d[i] + byV * v.d[i];
    return result;
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    using std::numbers::pi;
    constexpr double kAwayFromPole = 1e-4;
    const Vector3 n = Sphere::getNormalAt(position);
    const double longitude = std::atan2(n.x, -n.z);
    const double polar =
        std::clamp(std::acos(std::clamp(n.y, -1.0, 1.0)), kAwayFromPole, pi - kAwayFromPole);

    const UV u = UV::variable(longitude / (2.0 * pi) + 0.5, 0);
    const UV v = UV::variable(polar / pi, 1);
    const UV lambda = (2.0 * pi) * (-0.5 + u);
    const UV theta = pi * v;

    const UV reach = radius() * (1.0 + 0.01 * heightAt(heightMap(), u, v));
    const std::array<UV, 3> s{reach * sin(lambda) * sin(theta), reach * cos(theta),
                              -1.0 * (reach * cos(lambda) * sin(theta))};

    const Vector3 su{s[0].d[0], s[1].d[0], s[2].d[0]};
    const Vector3 sv{s[0].d[1], s[1].d[1], s[2].d[1]};
    return su.cross(sv).normalised();  // right x down is outwards here
    // TASK T1 end
}

}  // namespace raytracer
