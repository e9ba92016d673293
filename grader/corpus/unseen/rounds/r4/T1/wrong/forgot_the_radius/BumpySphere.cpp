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
    Vector3 p = position - centre();
    double lon = std::atan2(p.x, -p.z);
    double pol = std::acos(std::clamp(p.y, -1.0, 1.0));
    int width = heightMap().width();
    int height = heightMap().height();

    int column = (int)(width * (0.5 + lon / (2.0 * std::numbers::pi)));
    int row = (int)(height * pol / std::numbers::pi);
    column = std::min(column, width - 1);
    row = std::min(row, height - 1);

    // tangents from the normal
    double ring = std::sqrt(n.x * n.x + n.z * n.z);
    Vector3 Pu(-n.z / ring, 0.0, n.x / ring);
    Vector3 Pv(n.y * n.x / ring, -ring, n.y * n.z / ring);

    double Bu = heightMap().at((column + 1) % width, row) - heightMap().at(column, row);
    double Bv = row + 1 < height ? heightMap().at(column, row + 1) - heightMap().at(column, row) : 0.0;
    return (n - Bu * Pu - Bv * Pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
