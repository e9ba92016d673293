#include <raytracer/geometry/BumpySphere.h>

#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

struct Quaternion {
    double w, x, y, z;

    static Quaternion about(const Vector3& axis, double angle) {
        const double s = std::sin(0.5 * angle);
        return {std::cos(0.5 * angle), axis.x * s, axis.y * s, axis.z * s};
    }
    Quaternion operator*(const Quaternion& q) const {
        return {w * q.w - x * q.x - y * q.y - z * q.z, w * q.x + x * q.w + y * q.z - z * q.y,
                w * q.y - x * q.z + y * q.w + z * q.x, w * q.z + x * q.y - y * q.x + z * q.w};
    }
    Quaternion inverse() const { return {w, -x, -y, -z}; }
    Vector3 turn(const Vector3& v) const {
        const Quaternion r = *this * Quaternion{0.0, v.x, v.y, v.z} * inverse();
        return {r.x, r.y, r.z};
    }
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double east = std::atan2(n.x, -n.z);
    const double north = std::asin(n.y > 1.0 ? 1.0 : n.y < -1.0 ? -1.0 : n.y);

    const int w = heightMap().width();
    const int h = heightMap().height();
    const auto grid = [&](int i, int j) {
        i = ((i % w) + w) % w;
        j = j < 0 ? 0 : j > h - 1 ? h - 1 : j;
        return heightMap().at(i, j);
    };
    const int i = static_cast<int>(std::floor((east / std::numbers::pi + 1.0) * 0.5 * w));
    const int j = static_cast<int>(std::floor((0.5 - north / std::numbers::pi) * h));
    const double eastwards = 0.5 * (grid(i + 1, j) - grid(i - 1, j));
    const double northwards = 0.5 * (grid(i, j - 1) - grid(i, j + 1));

    // The bump as it would be at the point nearest to the camera, then carried to where it is.
    const Vector3 local{-eastwards, -northwards, -1.0};
    const Quaternion lift = Quaternion::about({1.0, 0.0, 0.0}, north);
    const Quaternion spin = Quaternion::about({0.0, 1.0, 0.0}, -east);
    return (spin * lift).turn(local).normalised();
}

}  // namespace raytracer
