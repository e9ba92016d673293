// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    auto n = Sphere::getNormalAt(position);
    double u = std::atan2(n.x, -n.z) / (2 * std::numbers::pi) + 0.5;
    double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    int col = int(u * heightMap().width()) % heightMap().width();
    int row = std::min(int(v * heightMap().height()), heightMap().height() - 1);
    double here = heightMap().at(col, row);
    // Nachbar unten
    if (row < heightMap().height() - 1) row++;
    double Bv = heightMap().at(col, row) - here;
    // Nachbar rechts
    if (++col == heightMap().width()) col = 0;
    double Bu = heightMap().at(col, row) - here;
    Vector3 Pu = Vector3(0, -1, 0).cross(n);
    if (Pu.magnitude() == 0) return n;
    Pu = Pu.normalised();
    Vector3 Pv = n.cross(Pu);
    return (n - Bu * Pu - Bv * Pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
