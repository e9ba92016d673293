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

    const Vector3 Pu{std::cos(phi), 0.0, std::sin(phi)};
    const Vector3 Pv{std::sin(phi) * std::cos(theta), -std::sin(theta),
                     -std::cos(phi) * std::cos(theta)};

    const HeightMap& map = heightMap();
    const int w = map.width();
    const int h = map.height();
    const int column = std::min(static_cast<int>((phi / (2 * std::numbers::pi) + 0.5) * w), w - 1);
    const int row = std::min(static_cast<int>(theta / std::numbers::pi * h), h - 1);

    // "taking your current pixel and subtracting from it the pixels below and to the right"
    const double Bu = map.at(column, row) - map.at((column + 1) % w, row);
    const double Bv = map.at(column, row) - map.at(column, std::min(row + 1, h - 1));

    return (n + Bu * n.cross(Pv) + Bv * n.cross(Pu)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
