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

struct Polar {
    double azimuth, inclination;
    static Polar of(const Vector3& n) {
        return {std::atan2(n.z, n.x), std::acos(std::clamp(n.y, -1.0, 1.0))};
    }
};
struct Basis {
    Vector3 east, south;
    explicit Basis(const Polar& p)
        : east{std::cos(p.azimuth), 0.0, -std::sin(p.azimuth)},
          south{std::sin(p.azimuth) * std::cos(p.inclination), -std::sin(p.inclination),
                std::cos(p.azimuth) * std::cos(p.inclination)} {}
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const Polar p = Polar::of(n);
    const Basis basis{p};
    const HeightMap& m = heightMap();
    const int w = m.width(), h = m.height();
    const int c = std::min(w - 1, int((p.azimuth / (2 * std::numbers::pi) + 0.5) * w));
    const int r = std::min(h - 1, int(p.inclination / std::numbers::pi * h));
    const double bu = m.at((c + 1) % w, r) - m.at(c, r);
    const double bv = (r + 1 < h ? m.at(c, r + 1) : m.at(c, r)) - m.at(c, r);
    return (n - bu * basis.east - bv * basis.south).normalised();
    // TASK T1 end
}

}  // namespace raytracer
