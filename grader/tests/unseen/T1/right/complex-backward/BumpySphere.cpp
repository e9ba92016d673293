#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace raytracer {
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    using C = std::complex<double>;
    const Vector3 n = Sphere::getNormalAt(position);
    const C flat{-n.z, n.x};  // the equatorial plane as the complex plane
    const C e = std::abs(flat) > 0 ? flat / std::abs(flat) : C{1, 0};
    const C m{n.y, std::abs(flat)};                                   // the meridian's half plane
    const double u = std::arg(e * C{0, 1}) / (2 * std::numbers::pi);  // a quarter turn on
    const double v = std::arg(m) / std::numbers::pi;

    const HeightMap& map = heightMap();
    const auto wrapped = [&](int c) { return ((c % map.width()) + map.width()) % map.width(); };
    const int c = wrapped(static_cast<int>(std::lround(u * map.width())));
    const int r = std::min(static_cast<int>(std::lround(v * (map.height() - 1))), map.height() - 1);
    // backward differences
    const double bu = map.at(c, r) - map.at(wrapped(c - 1), r);
    const double bv = r > 0 ? map.at(c, r) - map.at(c, r - 1) : 0.0;

    // i times a direction is the direction to its right
    const C right = e * C{0, 1};
    const C down = m / std::abs(m) * C{0, 1};
    const Vector3 pu{right.imag(), 0, -right.real()};
    const Vector3 pv{down.imag() * e.imag(), down.real(), -down.imag() * e.real()};
    Vector3 out = n;
    out -= pu * bu;
    out -= pv * bv;
    return out.normalised();
}
}  // namespace raytracer
