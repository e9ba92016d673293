// T1. Bright = high, so only a step UP makes a bump; a step down is ignored.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

struct UV {
    double u, v;
};

UV project(const Vector3& n) {
    UV uv;
    uv.u = std::atan2(n.x, -n.z) / (2 * std::numbers::pi) + 0.5;
    uv.v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    return uv;
}

double saturate(double slope) { return std::clamp(slope, 0.0, kBumpFactor); }

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const UV uv = project(n);
    const int w = heightMap().width(), h = heightMap().height();
    const int x = std::min<int>(uv.u * w, w - 1), y = std::min<int>(uv.v * h, h - 1);
    const double b = heightMap().at(x, y);
    const double bu = saturate(heightMap().at(x == w - 1 ? 0 : x + 1, y) - b);
    const double bv = saturate(heightMap().at(x, y == h - 1 ? y : y + 1) - b);

    const double lon = (uv.u - 0.5) * 2 * std::numbers::pi;
    const Vector3 pu{std::cos(lon), 0, std::sin(lon)};
    const Vector3 pv = n.cross(pu);
    return (n + bu * n.cross(pv) - bv * n.cross(pu)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
