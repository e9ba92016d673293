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
    double pi = std::numbers::pi;
    double lon = std::atan2(n.x, -n.z);
    double pol = std::acos(std::clamp(n.y, -1.0, 1.0));
    double u = 0.5 + lon / (2 * pi);
    double v = pol / pi;

    int column = (int)(u * heightMap().height());
    if (column >= heightMap().width()) column = heightMap().width() - 1;
    int row = (int)(v * heightMap().height());
    if (row >= heightMap().height()) row = heightMap().height() - 1;
    int nextColumn = column + 1;
    if (nextColumn >= heightMap().width()) nextColumn = 0;
    int nextRow = row + 1;
    if (nextRow >= heightMap().height()) nextRow = heightMap().height() - 1;

    double Bu = heightMap().at(nextColumn, row) - heightMap().at(column, row);
    double Bv = heightMap().at(column, nextRow) - heightMap().at(column, row);
    Vector3 Pu(std::cos(lon), 0, std::sin(lon));
    Vector3 Pv(std::sin(lon) * std::cos(pol), -std::sin(pol), -std::cos(lon) * std::cos(pol));
    return (n - Pu * Bu - Pv * Bv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
