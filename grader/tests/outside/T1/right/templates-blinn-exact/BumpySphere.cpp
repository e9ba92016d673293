#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <array>
#include <concepts>
#include <numeric>

namespace raytracer {

namespace detail {
template <std::floating_point T> using V = std::array<T, 3>;
template <std::floating_point T> constexpr V<T> axpy(T a, const V<T>& x, const V<T>& y) {
    V<T> o{};
    std::transform(x.begin(), x.end(), y.begin(), o.begin(), [a](T p, T q) { return a * p + q; });
    return o;
}
template <std::floating_point T> T norm(const V<T>& v) { return std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), T{})); }
template <int Axis, std::floating_point T> T slope(const HeightMap& m, int c, int r) {
    if constexpr (Axis == 0) return T(m.at((c + 1) % m.width(), r) - m.at((c + m.width() - 1) % m.width(), r)) / 2;
    else return T(m.at(c, std::min(r + 1, m.height() - 1)) - m.at(c, std::max(r - 1, 0))) / 2;
}
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    using Real = long double;
    const Vector3 s = Sphere::getNormalAt(position);
    const detail::V<Real> n{s.x, s.y, s.z};
    constexpr Real pi = std::numbers::pi_v<Real>;
    const Real phi = std::atan2(n[0], -n[2]), theta = std::acos(std::clamp<Real>(n[1], -1, 1));
    const int c = std::clamp(int((phi + pi) / (2 * pi) * heightMap().width()), 0, heightMap().width() - 1);
    const int r = std::clamp(int(theta / pi * heightMap().height()), 0, heightMap().height() - 1);
    const detail::V<Real> pu{std::sin(theta) * std::cos(phi), 0, std::sin(theta) * std::sin(phi)};
    const detail::V<Real> pv{std::cos(theta) * std::sin(phi), -std::sin(theta), -std::cos(theta) * std::cos(phi)};
    auto b = detail::axpy<Real>(-detail::slope<0, Real>(heightMap(), c, r), pu, n);
    b = detail::axpy<Real>(-detail::slope<1, Real>(heightMap(), c, r), pv, b);
    const Real l = detail::norm(b);
    return {double(b[0] / l), double(b[1] / l), double(b[2] / l)};
}

}  // namespace raytracer
