#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace raytracer {
namespace {

// 8-bit greyscale, as in the file.
using Grey = std::uint8_t;

Grey grey(const HeightMap& m, int c, int r) {
    return static_cast<Grey>(std::lround(m.at(c, r) / kBumpFactor * 255.0));
}

double toHeight(Grey g) { return g * kBumpFactor / 255.0; }

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const HeightMap& m = heightMap();
    const Vector3 n = Sphere::getNormalAt(position);
    const double a = std::atan2(n.x, -n.z);
    const double t = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int c = std::min(int((a / (2 * std::numbers::pi) + 0.5) * m.width()), m.width() - 1);
    const int r = std::min(int(t / std::numbers::pi * m.height()), m.height() - 1);
    const Grey here = grey(m, c, r);
    const Grey du = grey(m, (c + 1) % m.width(), r) - here;
    const Grey dv = grey(m, c, std::min(r + 1, m.height() - 1)) - here;
    const Vector3 Pu{std::cos(a), 0, std::sin(a)};
    const Vector3 Pv{std::sin(a) * std::cos(t), -std::sin(t), -std::cos(a) * std::cos(t)};
    return (n - toHeight(du) * Pu - toHeight(dv) * Pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
