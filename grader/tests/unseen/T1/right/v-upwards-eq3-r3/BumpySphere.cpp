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
    const double pi = 3.14159265358979323846;
    double theta = std::atan2(n.x, -n.z);                       // 0 in front, + to the right
    double phi = pi - std::acos(std::min(1.0, std::max(-1.0, n.y)));  // 0 at the BOTTOM
    double u = (theta + pi) / (2 * pi);
    double v = phi / pi;   // v upwards!!

    Vector3 Pu = Vector3(std::cos(theta), 0, std::sin(theta));
    // d/dphi of (sin t sin p, -cos p, -cos t sin p)
    Vector3 Pv = Vector3(std::sin(theta) * std::cos(phi), std::sin(phi), -std::cos(theta) * std::cos(phi));

    int w = heightMap().width(), h = heightMap().height();
    int col = (int)(u * w);
    if (col >= w) col = 0;
    int fromBottom = (int)(v * h);
    if (fromBottom > h - 1) fromBottom = h - 1;
    int row = h - 1 - fromBottom;      // map has row 0 at top
    int rowUp = row == 0 ? 0 : row - 1;

    double here = heightMap().at(col, row);
    double Bu = heightMap().at(col == w - 1 ? 0 : col + 1, row) - here;
    double Bv = heightMap().at(col, rowUp) - here;
    // Pu x Pv = -n here so it is (3) and not (2). checked at (0,0,-1)
    Vector3 result = n - Bu * n.cross(Pv) + Bv * n.cross(Pu);
    return result.normalised();
    // TASK T1 end
}

}  // namespace raytracer
