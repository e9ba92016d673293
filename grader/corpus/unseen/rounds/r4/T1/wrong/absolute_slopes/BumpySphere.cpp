// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 n = Sphere::getNormalAt(position);
    double theta = std::atan2(n.x, -n.z);
    double phi = std::acos(std::clamp(n.y, -1.0, 1.0));
    int w = heightMap().width(), h = heightMap().height();
    int col = (int)((theta + std::numbers::pi) / (2 * std::numbers::pi) * w);
    int row = (int)(phi / std::numbers::pi * h);
    col = std::min(col, w - 1);
    row = std::min(row, h - 1);

    double Bu = std::abs(heightMap().at((col + 1) % w, row) - heightMap().at(col, row));
    double Bv = std::abs(heightMap().at(col, std::min(row + 1, h - 1)) - heightMap().at(col, row));

    Vector3 Pu{std::cos(theta), 0, std::sin(theta)};
    Vector3 Pv{std::sin(theta) * std::cos(phi), -std::sin(phi), -std::cos(theta) * std::cos(phi)};
    return (n + Bu * n.cross(Pv) - Bv * n.cross(Pu)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
