#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace raytracer {

using C = std::complex<double>;

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    constexpr double strength = 0.5; // looks nicer
    const Vector3 n = Sphere::getNormalAt(position);
    const C ground{n.x, n.z};
    const double ring = std::abs(ground);
    const C spin = ring > 0 ? ground / ring : C{1, 0};
    const C ahead = spin * C{0, 1};                       // a quarter turn further = tangent along u
    double u = std::arg(spin) / (2 * std::numbers::pi);
    if (u < 0) u += 1;
    const double v = std::acos(std::clamp(n.y, -1., 1.)) / std::numbers::pi;

    auto& map = heightMap();
    const int W = map.width(), H = map.height();
    const int c = std::clamp(int(u * W), 0, W - 1);
    const int r = std::clamp(int(v * H), 0, H - 1);
    const double z = map.at(c, r);
    const double du = strength * (map.at((c + 1) % W, r) - z);
    const double dv = strength * (r < H - 1 ? map.at(c, r + 1) - z : 0.);

    const Vector3 Pu{ahead.real(), 0, ahead.imag()};
    const Vector3 Pv{spin.real() * n.y, -ring, spin.imag() * n.y};
    return (n - du * Pu - dv * Pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
