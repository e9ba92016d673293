#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <complex>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    using namespace std::complex_literals;
    const Vector3 n = Sphere::getNormalAt(position);
    const std::complex<double> flat{-n.z, n.x};
    const std::complex<double> around = std::abs(flat) > 0 ? flat / std::abs(flat) : 1.0;
    const std::complex<double> upright{n.y, std::abs(flat)};
    double u = std::arg(around) / (2 * std::numbers::pi);
    if (u < 0) u += 1;
    const double v = std::arg(upright) / std::numbers::pi;
    const auto index = [](double t, int size) { return std::clamp(static_cast<int>(std::floor(t * size)), 0, size - 1); };
    const int c = index(u, heightMap().width()), r = index(v, heightMap().height());
    const int before = c == 0 ? heightMap().width() - 1 : c - 1;
    const double bu = heightMap().at(c, r) - heightMap().at(before, r);
    const double bv = r == 0 ? 0 : heightMap().at(c, r) - heightMap().at(c, r - 1);
    const std::complex<double> east = around * 1i;
    const std::complex<double> tilt = upright * 1i;  // (y, outwards)
    const Vector3 pu{east.imag(), 0, -east.real()};
    const Vector3 pv{tilt.imag() * around.imag(), tilt.real(), -tilt.imag() * around.real()};
    return (n - bu * pu - bv * pv).normalised();
}

}  // namespace raytracer
