// Tangents by automatic differentiation: no derivative is written down by hand.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

template <typename T, std::size_t N>
struct Dual {
    T value{};
    std::array<T, N> eps{};

    static constexpr Dual variable(T x, std::size_t which) {
        Dual d{x, {}};
        d.eps[which] = T{1};
        return d;
    }
    friend constexpr Dual operator*(const Dual& a, const Dual& b) {
        Dual r{a.value * b.value, {}};
        for (std::size_t i = 0; i < N; ++i) r.eps[i] = a.value * b.eps[i] + a.eps[i] * b.value;
        return r;
    }
    friend constexpr Dual operator*(T s, const Dual& a) { return Dual{s, {}} * a; }
    friend constexpr Dual operator+(const Dual& a, T s) { return {a.value + s, a.eps}; }
    friend constexpr Dual operator-(const Dual& a) { return T{-1} * a; }

    template <typename F, typename G>
    [[nodiscard]] Dual chain(F f, G derivative) const {
        Dual r{f(value), {}};
        const T slope = derivative(value);
        for (std::size_t i = 0; i < N; ++i) r.eps[i] = slope * eps[i];
        return r;
    }
};

using D2 = Dual<double, 2>;

D2 sin(const D2& a) {
    return a.chain([](double x) { return std::sin(x); }, [](double x) { return std::cos(x); });
}
D2 cos(const D2& a) {
    return a.chain([](double x) { return std::cos(x); }, [](double x) { return -std::sin(x); });
}

/// The unit sphere, over any number type.
template <typename S>
std::array<S, 3> spherePoint(const S& u, const S& v) {
    const S lon = (2.0 * std::numbers::pi) * (u + -0.5);
    const S pol = std::numbers::pi * v;
    return {sin(lon) * sin(pol), cos(pol), -(cos(lon) * sin(pol))};
}

Vector3 partial(const std::array<D2, 3>& p, std::size_t which) {
    return {p[0].eps[which], p[1].eps[which], p[2].eps[which]};
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double u = 0.5 + std::atan2(n.x, -n.z) / (2.0 * std::numbers::pi);
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;

    const auto p = spherePoint(D2::variable(u, 0), D2::variable(v, 1));
    Vector3 pu = partial(p, 0);
    const Vector3 pv = partial(p, 1).normalised();
    // At the poles all meridians meet: no direction is "along u".
    pu = pu.magnitude() > 1e-9 ? pu.normalised() : Vector3{};

    const HeightMap& map = heightMap();
    const int c = std::min(static_cast<int>(u * map.width()), map.width() - 1);
    const int r = std::min(static_cast<int>(v * map.height()), map.height() - 1);
    const double here = map.at(c, r);
    const double bu = map.at(c + 1 == map.width() ? 0 : c + 1, r) - here;
    const double bv = r + 1 == map.height() ? 0.0 : map.at(c, r + 1) - here;
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
