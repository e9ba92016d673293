// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 normal = Sphere::getNormalAt(position);
    const double longitude = std::atan2(normal.x, -normal.z);
    const double polar = std::acos(std::clamp(normal.y, -1.0, 1.0));
    const double u = longitude / (2 * std::numbers::pi) + 0.5;
    const double v = polar / std::numbers::pi;

    int column = (int)(u * heightMap().width());
    int row = (int)v * heightMap().height();
    if (column >= heightMap().width()) column = heightMap().width() - 1;
    if (row >= heightMap().height()) row = heightMap().height() - 1;

    int right = column + 1 == heightMap().width() ? 0 : column + 1;
    int below = row + 1 == heightMap().height() ? row : row + 1;
    const double Bu = heightMap().at(right, row) - heightMap().at(column, row);
    const double Bv = heightMap().at(column, below) - heightMap().at(column, row);

    const Vector3 Pu{std::cos(longitude), 0.0, std::sin(longitude)};
    const Vector3 Pv{std::sin(longitude) * std::cos(polar), -std::sin(polar),
                     -std::cos(longitude) * std::cos(polar)};
    return (normal + Bu * normal.cross(Pv) - Bv * normal.cross(Pu)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
