#include <raytracer/geometry/BumpySphere.h>
#include <cmath>
#include <numbers>

namespace {
using raytracer::Vector3;

// Hamilton's numbers; a frame is turned from the front of the sphere to the point.
struct Quaternion {
    double w, x, y, z;
    static Quaternion turn(const Vector3& axis, double angle) {
        const double s = std::sin(angle / 2);
        return {std::cos(angle / 2), axis.x * s, axis.y * s, axis.z * s};
    }
    Quaternion operator*(const Quaternion& q) const {
        return {w * q.w - x * q.x - y * q.y - z * q.z, w * q.x + x * q.w + y * q.z - z * q.y,
                w * q.y - x * q.z + y * q.w + z * q.x, w * q.z + x * q.y - y * q.x + z * q.w};
    }
    Quaternion conjugate() const { return {w, -x, -y, -z}; }
    Vector3 apply(const Vector3& v) const {
        const Quaternion r = *this * Quaternion{0, v.x, v.y, v.z} * conjugate();
        return {r.x, r.y, r.z};
    }
};
}  // namespace

namespace raytracer {
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 d = (position - centre()) / radius();
    const double east = std::atan2(d.x, -d.z);
    const double north = std::asin(std::fmax(-1.0, std::fmin(1.0, d.y)));
    const Quaternion q = Quaternion::turn({0, 1, 0}, -east) * Quaternion::turn({1, 0, 0}, north);
    const Vector3 out = q.apply({0, 0, -1}), right = q.apply({1, 0, 0}), up = q.apply({0, 1, 0});

    const HeightMap& m = heightMap();
    int i = static_cast<int>(std::floor((east / (2 * std::numbers::pi) + 0.5) * m.width()));
    int j = static_cast<int>(std::floor((0.5 - north / std::numbers::pi) * m.height()));
    if (i >= m.width()) i -= m.width();
    if (j >= m.height()) j = m.height() - 1;
    const int iNext = i + 1 == m.width() ? 0 : i + 1;
    const int jUp = j == 0 ? 0 : j - 1;
    const double toRight = m.at(iNext, j) - m.at(i, j);
    const double toTop = m.at(i, jUp) - m.at(i, j);
    return (out - right * toRight - up * toTop).normalised();
}
}  // namespace raytracer
