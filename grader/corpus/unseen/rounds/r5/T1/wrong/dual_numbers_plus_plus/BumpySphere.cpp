#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace raytracer {
namespace {

template <std::size_t N>
struct Jet {
    double a = 0;
    std::array<double, N> d{};
    Jet(double x) : a(x) {}
    static Jet var(double x, std::size_t i) { Jet j(x); j.d[i] = 1; return j; }
};
template <std::size_t N> Jet<N> operator*(const Jet<N>& x, const Jet<N>& y) {
    Jet<N> r(x.a * y.a);
    for (std::size_t i = 0; i < N; ++i) r.d[i] = x.a * y.d[i] + x.d[i] * y.a;
    return r;
}
template <std::size_t N> Jet<N> lift(const Jet<N>& x, double f, double df) {
    Jet<N> r(f);
    for (std::size_t i = 0; i < N; ++i) r.d[i] = df * x.d[i];
    return r;
}
template <std::size_t N> Jet<N> sin(const Jet<N>& x) { return lift(x, std::sin(x.a), std::cos(x.a)); }
template <std::size_t N> Jet<N> cos(const Jet<N>& x) { return lift(x, std::cos(x.a), -std::sin(x.a)); }

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    using J = Jet<2>;
    const Vector3 n = Sphere::getNormalAt(position);
    const J lon = J::var(std::atan2(n.x, -n.z), 0);
    const J pol = J::var(std::acos(std::clamp(n.y, -1.0, 1.0)), 1);
    const std::array<J, 3> p{sin(lon) * sin(pol), cos(pol), J(-1) * cos(lon) * sin(pol)};
    const auto d = [&p](int i) { return Vector3{p[0].d[i], p[1].d[i], p[2].d[i]}; };
    const double ring = d(0).magnitude();
    const Vector3 Pu = ring > 1e-9 ? d(0) / ring : Vector3{1, 0, 0}, Pv = d(1).normalised();

    const HeightMap& m = heightMap();
    const int c = std::min(m.width() - 1, int((lon.a / (2 * std::numbers::pi) + .5) * m.width()));
    const int r = std::min(m.height() - 1, int(pol.a / std::numbers::pi * m.height()));
    const double Bu = m.at((c + 1) % m.width(), r) - m.at(c, r);
    const double Bv = m.at(c, std::min(r + 1, m.height() - 1)) - m.at(c, r);
    // Blinn, eq. 4
    return (n + Bu * n.cross(Pv) + Bv * n.cross(Pu)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
