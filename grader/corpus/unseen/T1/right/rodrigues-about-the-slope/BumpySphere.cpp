#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

struct Spot {
    double u, v;
    Vector3 pu, pv;
};

Spot textureAt(const Vector3& n) {
    const double a = std::atan2(n.x, -n.z);
    const double t = std::acos(std::clamp(n.y, -1., 1.));
    return {a / (2 * std::numbers::pi) + .5, t / std::numbers::pi,
            {std::cos(a), 0, std::sin(a)},
            {std::sin(a) * std::cos(t), -std::sin(t), -std::cos(a) * std::cos(t)}};
}

/// Rodrigues' formula; the axis has unit length.
Vector3 rotate(const Vector3& p, const Vector3& axis, double angle) {
    return p * std::cos(angle) + axis.cross(p) * std::sin(angle) +
           axis * (axis.dot(p) * (1 - std::cos(angle)));
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const auto n = Sphere::getNormalAt(position);
    const auto s = textureAt(n);
    const auto& map = heightMap();
    const auto x = std::min<int>(map.width() - 1, s.u * map.width());
    const auto y = std::min<int>(map.height() - 1, s.v * map.height());
    const auto du = map.at((x + 1) % map.width(), y) - map.at(x, y);
    const auto dv = map.at(x, std::min(y + 1, map.height() - 1)) - map.at(x, y);

    // The steepest way up in the tangent plane, and how steep it is.
    const Vector3 uphill = s.pu * du + s.pv * dv;
    const double slope = uphill.magnitude();
    if (slope == 0.0) return n;
    // Lean away from it by the slope's angle.
    const Vector3 axis = n.cross(uphill / slope);
    return rotate(n, axis, -std::atan(slope)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
