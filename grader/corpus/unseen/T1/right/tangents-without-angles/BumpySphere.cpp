#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);

    // The circle of latitude has the radius ring; its tangent is (x, z) turned by a quarter.
    const double ring = std::hypot(n.x, n.z);
    const Vector3 right = ring > 1e-12 ? Vector3{-n.z / ring, 0.0, n.x / ring} : Vector3{1.0, 0.0, 0.0};
    const Vector3 down = right.cross(n).dot(Vector3{0.0, -1.0, 0.0}) >= 0.0 ? right.cross(n) : n.cross(right);

    const HeightMap& map = heightMap();
    const double u = 0.5 + std::atan2(n.x, -n.z) / kTurn;
    const double v = std::atan2(ring, n.y) / (kTurn / 2.0);
    const int c = std::clamp(static_cast<int>(std::floor(u * map.width())), 0, map.width() - 1);
    const int r = std::clamp(static_cast<int>(std::floor(v * map.height())), 0, map.height() - 1);

    const double here = map.at(c, r);
    const double slopeRight = map.at(c + 1 == map.width() ? 0 : c + 1, r) - here;
    const double slopeDown = r + 1 < map.height() ? map.at(c, r + 1) - here : 0.0;

    // One tilt after the other: n x P_u does not change when n leans along P_u.
    Vector3 tilted = n;
    tilted = (tilted - right * slopeRight).normalised() * std::sqrt(1.0 + slopeRight * slopeRight);
    tilted -= down * slopeDown;
    return tilted.normalised();
    // TASK T1 end
}

}  // namespace raytracer
