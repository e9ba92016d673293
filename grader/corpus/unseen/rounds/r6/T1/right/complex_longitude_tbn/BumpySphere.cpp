#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    using C = std::complex<double>;
    const Vector3 n = Sphere::getNormalAt(position);
    const C equator{-n.z, n.x};                    // sin(theta) e^{i lambda}
    const double rho = std::abs(equator);
    const C e = rho > 1e-12 ? equator / rho : C{1.0, 0.0};
    const C meridian{n.y, rho};                    // e^{i theta}

    const auto& map = heightMap();
    const auto wrap = [](double t) { return t - std::floor(t); };
    const int w = map.width(), h = map.height();
    const int x = int(wrap(std::arg(e) / (2 * std::numbers::pi)) * w) % w;   // u = 0 in front
    const int y = std::min(int(std::arg(meridian) / std::numbers::pi * h), h - 1);

    const double here = map.at(x, y);
    const double tangentSpace[3] = {here - map.at((x + 1) % w, y),
                                    here - (y < h - 1 ? map.at(x, y + 1) : here), 1.0};
    const Vector3 T{e.real(), 0.0, e.imag()};
    const Vector3 B{e.imag() * n.y, -rho, -e.real() * n.y};
    return (T * tangentSpace[0] + B * tangentSpace[1] + n * tangentSpace[2]).normalised();
}

}  // namespace raytracer
