// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    // from the theory: x = sin t cos p, y = cos t, z = sin t sin p
    Vector3 n = Sphere::getNormalAt(position);
    double p = std::atan2(n.x, n.z);
    double t = std::acos(std::clamp(n.y, -1.0, 1.0));
    Vector3 Pu(-std::sin(p), 0, std::cos(p));
    Vector3 Pv(std::cos(t) * std::cos(p), -std::sin(t), std::cos(t) * std::sin(p));

    double u = p / (2 * std::numbers::pi) + 0.5;
    double v = t / std::numbers::pi;
    int cols = heightMap().width();
    int rows = heightMap().height();
    int c = (int)(u * cols);
    int r = (int)(v * rows);
    if (c == cols) c = 0;
    if (r == rows) r = rows - 1;
    int c2 = c + 1;
    if (c2 == cols) c2 = 0;
    int r2 = r + 1;
    if (r2 == rows) r2 = r;
    double Bu = heightMap().at(c2, r) - heightMap().at(c, r);
    double Bv = heightMap().at(c, r2) - heightMap().at(c, r);
    return (n - Bu * Pu - Bv * Pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
