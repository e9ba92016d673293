// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

struct Quaternion {
    double w;
    Vector3 v;
    Quaternion operator*(const Quaternion& o) const {
        return {w * o.w - v.dot(o.v), w * o.v + o.w * v + v.cross(o.v)};
    }
    Vector3 rotate(const Vector3& p) const {
        const Vector3 t = 2.0 * v.cross(p);
        return p + w * t + v.cross(t);
    }
};

Quaternion aboutAxis(const Vector3& axis, double angle) {
    return {std::cos(angle / 2), axis * std::sin(angle / 2)};
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 out = (position - centre()) * (1.0 / radius());
    const double yaw = std::atan2(out.x, -out.z);
    const double pitch = std::atan2(out.y, std::hypot(out.x, out.z));  // latitude
    // Front of the sphere: right is +x, down is -y, outwards is -z.
    const Quaternion turn = aboutAxis({0, 1, 0}, -yaw) * aboutAxis({1, 0, 0}, pitch);

    const HeightMap& map = heightMap();
    const int w = map.width(), h = map.height();
    int i = static_cast<int>(w * (yaw + std::numbers::pi) / (2 * std::numbers::pi));
    int j = static_cast<int>(h * (0.5 - pitch / std::numbers::pi));
    if (i >= w) i = w - 1;
    if (i < 0) i = 0;
    if (j >= h) j = h - 1;
    if (j < 0) j = 0;
    const double slopeRight = map.at((i + 1) % w, j) - map.at(i, j);
    const double slopeDown = j + 1 < h ? map.at(i, j + 1) - map.at(i, j) : 0.0;
    return turn.rotate(Vector3(-slopeRight, slopeDown, -1.0)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
