// The tilt as a rotation: n is turned by the angle atan |grad B| about the axis n x (-grad B).
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

struct Quaternion {
    double w;
    Vector3 v;

    static Quaternion rotation(const Vector3& unitAxis, double angle) {
        return {std::cos(angle / 2), unitAxis * std::sin(angle / 2)};
    }
    Quaternion conjugate() const { return {w, -v}; }
    friend Quaternion operator*(const Quaternion& a, const Quaternion& b) {
        return {a.w * b.w - a.v.dot(b.v), a.w * b.v + b.w * a.v + a.v.cross(b.v)};
    }
    Vector3 turn(const Vector3& p) const { return (*this * Quaternion{0.0, p} * conjugate()).v; }
};

struct Place {
    double u, v;
    Vector3 east, south;
};

// The frame at the front of the globe, turned twice: down from the equator, then round the y axis.
Place placeOf(const Vector3& n) {
    const double lon = std::atan2(n.x, -n.z);
    const double polar = std::acos(std::clamp(n.y, -1.0, 1.0));
    const Vector3 eastAxis{1, 0, 0};
    const Vector3 upAxis{0, 1, 0};
    const Quaternion spin = Quaternion::rotation(upAxis, -lon);
    const Quaternion pitch = Quaternion::rotation(eastAxis, std::numbers::pi / 2 - polar);
    const Quaternion both = spin * pitch;
    return {lon / (2 * std::numbers::pi) + 0.5, polar / std::numbers::pi, both.turn(eastAxis),
            both.turn(-upAxis)};
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const Place place = placeOf(n);
    const HeightMap& map = heightMap();

    const int c = std::min(static_cast<int>(place.u * map.width()), map.width() - 1);
    const int r = std::min(static_cast<int>(place.v * map.height()), map.height() - 1);
    const double b = map.at(c, r);
    const double slopeEast = map.at((c + 1) % map.width(), r) - b;
    const double slopeSouth = r + 1 < map.height() ? map.at(c, r + 1) - b : 0.0;

    const Vector3 downhill = -(place.east * slopeEast + place.south * slopeSouth);
    const double steepness = downhill.magnitude();
    if (steepness < 1e-12) return n;
    const Vector3 axis = n.cross(downhill / steepness).normalised();
    return Quaternion::rotation(axis, std::atan(steepness)).turn(n).normalised();
    // TASK T1 end
}

}  // namespace raytracer
