// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double phi = std::atan2(n.x, -n.z);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double sp = std::sin(phi), cp = std::cos(phi);
    const double st = std::sin(theta), ct = std::cos(theta);
    // n = (st sp, ct, -st cp)
    const Vector3 pu(cp, 0, sp);
    const Vector3 pv(ct * sp, -st, ct * cp);

    const int w = heightMap().width();
    const int h = heightMap().height();
    const int x = std::min(static_cast<int>((phi / (2 * std::numbers::pi) + 0.5) * w), w - 1);
    const int y = std::min(static_cast<int>(theta / std::numbers::pi * h), h - 1);
    const double b = heightMap().at(x, y);
    const double bu = heightMap().at(x == w - 1 ? 0 : x + 1, y) - b;
    const double bv = y == h - 1 ? 0.0 : heightMap().at(x, y + 1) - b;

    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
