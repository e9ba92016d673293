#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace raytracer {
namespace detail_bump {

using Kernel = std::array<std::array<int, 3>, 3>;  // [row][column]

constexpr Kernel transpose(const Kernel& k) {
    Kernel t{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) t[j][i] = k[i][j];
    return t;
}

constexpr Kernel kScharrX{{{-3, 0, 3}, {-10, 0, 10}, {-3, 0, 3}}};
constexpr Kernel kScharrY = transpose(kScharrX);

template <const Kernel& K, std::size_t... I>
double convolve(const HeightMap& m, int c, int r, std::index_sequence<I...>) {
    const auto at = [&](int dc, int dr) {
        const int w = m.width();
        return m.at((c + dc + w) % w, std::clamp(r + dr, 0, m.height() - 1));
    };
    return (0.0 + ... + (K[I / 3][I % 3] * at(static_cast<int>(I % 3) - 1, static_cast<int>(I / 3) - 1)));
}

template <const Kernel& K>
double gradient(const HeightMap& m, int c, int r) {
    return convolve<K>(m, c, r, std::make_index_sequence<9>{}) / 32.0;
}

}  // namespace detail_bump

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    using namespace detail_bump;
    using namespace std::complex_literals;
    const Vector3 n = Sphere::getNormalAt(position);
    const std::complex<double> equator{-n.z, n.x};  // 1 is in front, i to the right
    const double ring = std::abs(equator);
    const std::complex<double> east = ring > 0.0 ? equator / ring * 1.0i : 1.0i;  // quarter turn on

    const HeightMap& map = heightMap();
    const double u = std::arg(equator) / (2.0 * std::numbers::pi) + 0.5;
    const double v = std::atan2(ring, n.y) / std::numbers::pi;  // never out of range
    const int c = std::clamp(static_cast<int>(u * map.width()), 0, map.width() - 1);
    const int r = std::clamp(static_cast<int>(v * map.height()), 0, map.height() - 1);

    const Vector3 pu{east.imag(), 0.0, -east.real()};
    const Vector3 pv = n.cross(pu);  // downwards
    return (n - gradient<kScharrX>(map, c, r) * pu - gradient<kScharrY>(map, c, r) * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
