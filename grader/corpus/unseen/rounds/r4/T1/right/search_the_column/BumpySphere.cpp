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
    double lon = std::atan2(n.x, -n.z) + std::numbers::pi;   // 0 .. 2 pi
    double pol = std::acos(std::clamp(n.y, -1.0, 1.0));      // 0 .. pi

    // find the texel by walking along the edges of the columns
    int column = 0;
    for (int k = 0; k < heightMap().width(); k++) {
        double leftEdge = 2.0 * std::numbers::pi * k / heightMap().width();
        if (lon >= leftEdge) column = k;
    }
    int row = 0;
    while (row < heightMap().height() - 1 &&
           pol >= std::numbers::pi * (row + 1) / heightMap().height()) {
        row++;
    }

    int nextColumn = column + 1;
    if (nextColumn >= heightMap().width()) nextColumn = nextColumn - heightMap().width();

    double slopeU = heightMap().at(nextColumn, row) - heightMap().at(column, row);
    double slopeV = 0.0;
    if (row + 1 < heightMap().height())
        slopeV = heightMap().at(column, row + 1) - heightMap().at(column, row);

    double s = std::sin(lon), c = std::cos(lon);
    // lon has pi added, so the signs of s and c are turned
    Vector3 Pu(-c, 0.0, -s);
    Vector3 Pv(-s * std::cos(pol), -std::sin(pol), c * std::cos(pol));
    Vector3 result = n;
    result -= Pu * slopeU;
    result -= Pv * slopeV;
    result /= result.magnitude();
    return result;
    // TASK T1 end
}

}  // namespace raytracer
