#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

struct Quaternion {
    double w;
    Vector3 v;
    static Quaternion about(const Vector3& axis, double angle) {
        return {std::cos(angle / 2), axis * std::sin(angle / 2)};
    }
    Quaternion operator*(const Quaternion& o) const {
        return {w * o.w - v.dot(o.v), o.v * w + v * o.w + v.cross(o.v)};
    }
    Quaternion conjugate() const { return {w, -v}; }
    Vector3 rotate(const Vector3& p) const { return ((*this) * Quaternion{0, p} * conjugate()).v; }
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double longitude = std::atan2(n.x, -n.z);
    const double polar = std::acos(std::clamp(n.y, -1.0, 1.0));

    // east and south are the X and the -Y axis, carried to the point by two rotations of the front.
    const Quaternion turn = Quaternion::about({0, 1, 0}, -longitude) *
                            Quaternion::about({1, 0, 0}, std::numbers::pi / 2 - polar);
    const Vector3 east = turn.rotate({1, 0, 0});
    const Vector3 south = turn.rotate({0, -1, 0});

    const HeightMap& map = heightMap();
    const int i = std::clamp(int((longitude / std::numbers::pi + 1) / 2 * map.width()), 0,
                             map.width() - 1);
    const int j = std::clamp(int(polar / std::numbers::pi * map.height()), 0, map.height() - 1);
    const double bu = map.at((i + 1) % map.width(), j) - map.at(i, j);
    const double bv = map.at(i, std::min(j + 1, map.height() - 1)) - map.at(i, j);

    const Vector3 uphill = east * bu + south * bv;
    const double steep = uphill.magnitude();
    if (steep < 1e-12) return n;
    const Vector3 axis = uphill.cross(n) / steep;
    return Quaternion::about(axis, std::atan(steep)).rotate(n).normalised();
}

}  // namespace raytracer
