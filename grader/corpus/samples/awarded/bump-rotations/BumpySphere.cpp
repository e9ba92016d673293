#include <raytracer/geometry/BumpySphere.h>

#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

Vector3 turn(const Vector3& v, const Vector3& axis, double angle) {
    return v * std::cos(angle) + axis.cross(v) * std::sin(angle) + axis * (axis.dot(v) * (1 - std::cos(angle)));
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double ring = std::hypot(n.x, n.z);
    if (ring == 0) return n;
    const Vector3 right{-n.z / ring, 0, n.x / ring};
    const Vector3 down = Vector3{n.x * n.y, -ring * ring, n.z * n.y} / ring;

    const HeightMap& m = heightMap();
    const double lon = std::atan2(-n.z, -n.x) + std::numbers::pi;
    const double lat = std::acos(n.y);
    const int i = static_cast<int>(std::round(lon / (2 * std::numbers::pi) * (m.width() - 1)));
    const int j = static_cast<int>(std::round(lat / std::numbers::pi * (m.height() - 1)));
    const int left = i == 0 ? m.width() - 1 : i - 1;
    const int above = j == 0 ? 0 : j - 1;
    const double riseRight = m.at(i, j) - m.at(left, j);
    const double riseDown = m.at(i, j) - m.at(i, above);

    // A positive turn about right x n carries n towards -right.
    const Vector3 first = turn(n, right.cross(n), std::atan(riseRight));
    const Vector3 second = turn(first, down.cross(n), std::atan(riseDown));
    return second.normalised();
}

}  // namespace raytracer
