// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

struct Quat {
    double w;
    Vector3 v;

    static Quat about(const Vector3& axis, double angle) {
        return {std::cos(angle / 2), axis * std::sin(angle / 2)};
    }
    Quat operator*(const Quat& o) const {
        return {w * o.w - v.dot(o.v), w * o.v + o.w * v + v.cross(o.v)};
    }
    Quat conj() const { return {w, -v}; }
    Vector3 turn(const Vector3& p) const { return ((*this) * Quat{0.0, p} * conj()).v; }
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    using std::numbers::pi;
    const Vector3 n = Sphere::getNormalAt(position);
    const double phi = std::atan2(n.x, -n.z);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));

    const auto& m = heightMap();
    const int col = static_cast<int>(std::lround((phi / (2 * pi) + 0.5) * (m.width() - 1)));
    const int row = static_cast<int>(std::lround(theta / pi * (m.height() - 1)));
    const double slopeRight = m.at((col + 1) % m.width(), row) - m.at(col, row);
    const double slopeDown = row + 1 < m.height() ? m.at(col, row + 1) - m.at(col, row) : 0.0;

    // At the north pole (0, 1, 0), facing longitude 0: right is +x, "down the map" is -z.
    const Vector3 bumpedPole(-slopeRight, 1.0, slopeDown);
    // Lean the pole over by theta towards -z, then carry it round by phi.
    const Quat q = Quat::about({0, 1, 0}, -phi) * Quat::about({1, 0, 0}, -theta);
    return q.turn(bumpedPole).normalised();
    // TASK T1 end
}

}  // namespace raytracer
