// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 d = position - centre();
    const Vector3 n = Sphere::getNormalAt(position);

    const double phi = std::atan2(d.z, d.x);
    const double theta = std::acos(std::clamp(d.y, -1.0, 1.0));

    double u = phi / (2.0 * std::numbers::pi);
    if (u < 0) u += 1;
    const double v = theta / std::numbers::pi;

    const HeightMap& map = heightMap();
    const int column = std::min(static_cast<int>(u * map.width()), map.width() - 1);
    const int row = std::min(static_cast<int>(v * map.height()), map.height() - 1);
    const int right = (column + 1) % map.width();
    const int down = std::min(row + 1, map.height() - 1);

    const double bu = map.at(right, row) - map.at(column, row);
    const double bv = map.at(column, down) - map.at(column, row);

    const double s = std::hypot(n.x, n.z);
    if (s < 1e-9) return n;
    const Vector3 pu(-n.z / s, 0.0, n.x / s);
    const Vector3 pv(n.y * n.x / s, -s, n.y * n.z / s);
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
