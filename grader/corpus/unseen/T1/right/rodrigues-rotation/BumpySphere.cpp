// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

// v turned by `angle` about the unit vector k.
Vector3 rodrigues(const Vector3& v, const Vector3& k, double angle) {
    return v * std::cos(angle) + k.cross(v) * std::sin(angle) +
           k * (k.dot(v) * (1.0 - std::cos(angle)));
}

double smoothHeight(const HeightMap& map, double x, double y) {
    const int w = map.width();
    const double x0 = std::floor(x), y0 = std::floor(y);
    const double fx = x - x0, fy = y - y0;
    const int c0 = ((static_cast<int>(x0) % w) + w) % w;
    const int c1 = (c0 + 1) % w;
    const int r0 = std::clamp(static_cast<int>(y0), 0, map.height() - 1);
    const int r1 = std::clamp(static_cast<int>(y0) + 1, 0, map.height() - 1);
    return std::lerp(std::lerp(map.at(c0, r0), map.at(c1, r0), fx),
                     std::lerp(map.at(c0, r1), map.at(c1, r1), fx), fy);
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const Vector3 east = n.cross({0, 1, 0});  // (-z, 0, x): to the right when seen from outside
    if (east.magnitude() < 1e-9) return n;
    const Vector3 pu = east.normalised();
    const Vector3 pv = n.cross(pu);  // downwards, since pu x pv = n

    const double u = std::atan2(n.z, n.x) / (2 * std::numbers::pi);
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const double x = u * heightMap().width() - 0.5;
    const double y = v * heightMap().height() - 0.5;
    const double here = smoothHeight(heightMap(), x, y);
    const double bu = smoothHeight(heightMap(), x + 1, y) - here;
    const double bv = smoothHeight(heightMap(), x, y + 1) - here;

    const Vector3 downhill = -(bu * pu + bv * pv);
    const double steepness = downhill.magnitude();
    if (steepness == 0.0) return n;
    const Vector3 axis = n.cross(downhill / steepness);
    return rodrigues(n, axis, std::atan(steepness)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
