#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace raytracer {

// The equator as the complex plane: real = towards the camera, imaginary = right.
// Multiplying by i is a quarter turn, so tangents need no sines.
using C = std::complex<double>;

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    using namespace std::complex_literals;
    const Vector3 n = Sphere::getNormalAt(position);
    const C equator{-n.z, n.x};
    const double ring = std::abs(equator);
    const C e = ring > 0.0 ? equator / ring : C{1.0};

    const double turns = std::arg(equator) / (2.0 * std::numbers::pi);   // -1/2 .. 1/2
    const double u = turns < 0.0 ? turns + 1.0 : turns;                  // begins in front
    const double v = std::arg(C{n.y, ring}) / std::numbers::pi;

    const auto space = [](C flat, double y) { return Vector3{flat.imag(), y, -flat.real()}; };
    const Vector3 Pu = space(1i * e, 0.0);
    const Vector3 Pv = space(e * n.y, -ring);

    const auto& b = heightMap();
    const int c = std::min(int(u * b.width()), b.width() - 1);
    const int r = std::min(int(v * b.height()), b.height() - 1);
    const double Bu = b.at((c + 1) % b.width(), r) - b.at(c, r);
    const double Bv = r == b.height() - 1 ? 0.0 : b.at(c, r + 1) - b.at(c, r);

    return (n - Pu * Bu - Pv * Bv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
