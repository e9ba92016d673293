// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

static double toDegrees(double rad) { return rad * 180.0 / 3.14159265358979; }
static double sinDeg(double deg) { return std::sin(deg * 3.14159265358979 / 180.0); }
static double cosDeg(double deg) { return std::cos(deg * 3.14159265358979 / 180.0); }

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 n = Sphere::getNormalAt(position);
    double lon = toDegrees(std::atan2(n.x, -n.z));           // -180 .. 180
    double pol = toDegrees(std::acos(std::clamp(n.y, -1.0, 1.0)));   // 0 .. 180
    if (lon < 0.0) lon += 360.0;
    if (lon >= 360.0) lon -= 360.0;

    int column = (int)(lon * heightMap().width() / 360.0);
    int row = (int)(pol * heightMap().height() / 180.0);
    if (column > heightMap().width() - 1) column = heightMap().width() - 1;
    if (row > heightMap().height() - 1) row = heightMap().height() - 1;

    double h0 = heightMap().at(column, row);
    double h1 = heightMap().at((column + 1) % heightMap().width(), row);
    double h2 = row == heightMap().height() - 1 ? h0 : heightMap().at(column, row + 1);

    Vector3 Pu(cosDeg(lon), 0.0, sinDeg(lon));
    Vector3 Pv(sinDeg(lon) * cosDeg(pol), -sinDeg(pol), -cosDeg(lon) * cosDeg(pol));
    return (n + (h0 - h1) * Pu + (h0 - h2) * Pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
