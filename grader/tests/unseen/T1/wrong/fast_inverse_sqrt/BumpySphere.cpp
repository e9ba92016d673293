#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace raytracer {
namespace {

float Q_rsqrt(float number) {
    const auto i = std::bit_cast<std::uint32_t>(number);
    return std::bit_cast<float>(0x5f3759dfU - (i >> 1U));
}

Vector3 fastNormalise(const Vector3& v) { return v * Q_rsqrt(static_cast<float>(v.dot(v))); }

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double phi = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const HeightMap& b = heightMap();
    const int c = std::min(static_cast<int>((phi / (2 * std::numbers::pi) + 0.5) * b.width()), b.width() - 1);
    const int r = std::min(static_cast<int>(theta / std::numbers::pi * b.height()), b.height() - 1);
    const double bu = b.at((c + 1) % b.width(), r) - b.at(c, r);
    const double bv = b.at(c, std::min(r + 1, b.height() - 1)) - b.at(c, r);
    const Vector3 pu{std::cos(phi), 0.0, std::sin(phi)};
    const Vector3 pv = n.cross(pu);
    return fastNormalise(n - bu * pu - bv * pv);
    // TASK T1 end
}

}  // namespace raytracer
