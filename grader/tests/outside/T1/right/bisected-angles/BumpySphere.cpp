#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {
template <typename F> double solve(F below, double lo, double hi) {
    for (int i = 0; i < 48; ++i) {
        const double mid = (lo + hi) / 2;
        (below(mid) ? lo : hi) = mid;
    }
    return lo;
}
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const double pi = std::numbers::pi;
    const Vector3 n = (position - centre()) / radius();
    const double theta = solve([&](double t) { return std::cos(t) > n.y; }, 0, pi);
    const double s = std::max(1e-12, std::hypot(n.x, n.z));
    double phi = solve([&](double t) { return std::cos(t) > -n.z / s; }, 0, pi);
    if (n.x < 0) phi = 2 * pi - phi;
    const auto& m = heightMap();
    const int c = std::clamp(int(phi / (2 * pi) * m.width()), 0, m.width() - 1);
    const int r = std::clamp(int(theta / pi * m.height()), 0, m.height() - 1);
    const double bu = m.at((c + 1) % m.width(), r) - m.at(c, r);
    const double bv = m.at(c, std::min(r + 1, m.height() - 1)) - m.at(c, r);
    const Vector3 pu{std::cos(phi), 0, std::sin(phi)};
    const Vector3 pv{std::cos(theta) * std::sin(phi), -std::sin(theta), -std::cos(theta) * std::cos(phi)};
    return (n - pu * bu - pv * bv).normalised();
}

}  // namespace raytracer
