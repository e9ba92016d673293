// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <cstdint>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    typedef uint8_t u8;
    struct { u8 col; uint16_t row; } t;
    const Vector3 n = Sphere::getNormalAt(position);
    double u = 0.5 + atan2(n.x, -n.z) / 2 / std::numbers::pi, v = acos(std::clamp(n.y, -1., 1.)) / std::numbers::pi;
    if (u >= 1) u = 0;
    if (v >= 1) v = 0.9999999;
    t.col = (u8)(int)(u * heightMap().width());
    t.row = (uint16_t)(v * heightMap().height());
    int next = t.col + 1, below = t.row + 1;
    if (next == heightMap().width()) next = 0;
    if (below == heightMap().height()) below = t.row;
    double b = heightMap().at(t.col, t.row);
    double bu = heightMap().at(next, t.row) - b, bv = heightMap().at(t.col, below) - b;
    double r = sqrt(n.x * n.x + n.z * n.z);
    if (r < 1e-9) r = 1e-9;
    Vector3 pu(-n.z / r, 0, n.x / r);
    Vector3 pv(n.x * n.y / r, -r, n.z * n.y / r);
    return (n - pu * bu - pv * bv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
