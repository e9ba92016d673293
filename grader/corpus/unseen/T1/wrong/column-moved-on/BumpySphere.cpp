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
    const HeightMap& map = heightMap();

    int column = static_cast<int>((phi / (2 * std::numbers::pi) + 0.5) * map.width());
    int row = static_cast<int>(theta / std::numbers::pi * map.height());
    if (column > map.width() - 1) column = map.width() - 1;
    if (row > map.height() - 1) row = map.height() - 1;

    const double here = map.at(column, row);

    if (++column == map.width()) column = 0;
    const double bu = map.at(column, row) - here;

    if (++row == map.height()) --row;
    const double bv = map.at(column, row) - here;

    const Vector3 pu{std::cos(phi), 0, std::sin(phi)};
    const Vector3 pv{std::cos(theta) * std::sin(phi), -std::sin(theta), -std::cos(theta) * std::cos(phi)};
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
