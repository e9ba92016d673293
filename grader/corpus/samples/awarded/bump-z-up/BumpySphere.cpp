// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 normal = Sphere::getNormalAt(position);

    // x = sin(theta) cos(phi), y = sin(theta) sin(phi), z = cos(theta)
    double theta = std::acos(std::clamp(normal.z, -1.0, 1.0));
    double phi = std::atan2(normal.y, normal.x);
    if (phi < 0.0) phi += 2.0 * std::numbers::pi;

    int width = heightMap().width();
    int height = heightMap().height();
    int col = static_cast<int>(phi / (2.0 * std::numbers::pi) * width) % width;
    int row = std::min(static_cast<int>(theta / std::numbers::pi * height), height - 1);

    double here = heightMap().at(col, row);
    double du = heightMap().at((col + 1) % width, row) - here;
    double dv = heightMap().at(col, std::min(row + 1, height - 1)) - here;

    Vector3 pu(-std::sin(phi), std::cos(phi), 0.0);
    Vector3 pv(std::cos(theta) * std::cos(phi), std::cos(theta) * std::sin(phi), -std::sin(theta));

    normal -= pu * du;
    normal -= pv * dv;
    return normal.normalised();
    // TASK T1 end
}

}  // namespace raytracer
