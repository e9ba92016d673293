#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

struct SurfaceUv {
    double u, v;
    Vector3 pu, pv;
};

// Archimedes: the height on the sphere is proportional to the area above, no acos needed.
SurfaceUv parametrise(const Vector3& n) {
    const double ring = std::sqrt(std::max(0.0, 1.0 - n.y * n.y));
    const double s = ring > 0.0 ? n.x / ring : 0.0;
    const double c = ring > 0.0 ? -n.z / ring : 1.0;
    return {std::atan2(s, c) / (2.0 * std::numbers::pi) + 0.5, (1.0 - n.y) / 2.0,
            {c, 0.0, s}, {s * n.y, -ring, -c * n.y}};
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const auto [u, v, pu, pv] = parametrise(n);
    const int c = std::clamp(static_cast<int>(u * heightMap().width()), 0, heightMap().width() - 1);
    const int r = std::clamp(static_cast<int>(v * heightMap().height()), 0, heightMap().height() - 1);
    const double here = heightMap().at(c, r);
    const double bu = heightMap().at((c + 1) % heightMap().width(), r) - here;
    const double bv = heightMap().at(c, std::min(r + 1, heightMap().height() - 1)) - here;
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
