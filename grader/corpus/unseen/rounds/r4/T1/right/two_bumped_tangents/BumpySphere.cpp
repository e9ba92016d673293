// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    // Blinn: bend both tangents by the slopes, then the normal is their cross product.
    Vector3 n = Sphere::getNormalAt(position);
    double lon = std::atan2(-n.x, -n.z);  // grows to the LEFT seen from the camera
    double th = std::acos(std::clamp(n.y, -1.0, 1.0));
    double u = lon / (2 * std::numbers::pi);
    if (u < 0) u = u + 1;
    u = 1 - u;                      // now to the right again
    if (u >= 1) u = u - 1;
    double v = th / std::numbers::pi;

    int c0 = static_cast<int>(u * heightMap().width());
    int r0 = static_cast<int>(v * heightMap().height());
    if (c0 > heightMap().width() - 1) c0 = heightMap().width() - 1;
    if (r0 > heightMap().height() - 1) r0 = heightMap().height() - 1;
    int c1 = c0 + 1;
    if (c1 > heightMap().width() - 1) c1 = 0;
    int r1 = r0 + 1;
    if (r1 > heightMap().height() - 1) r1 = r0;

    double Bu = heightMap().at(c1, r0) - heightMap().at(c0, r0);
    double Bv = heightMap().at(c0, r1) - heightMap().at(c0, r0);

    Vector3 Pu{std::cos(lon), 0.0, -std::sin(lon)};
    Vector3 Pv{-std::sin(lon) * std::cos(th), -std::sin(th), -std::cos(lon) * std::cos(th)};

    Vector3 Qu = Pu + Bu * n;
    Vector3 Qv = Pv + Bv * n;
    Vector3 m = Qu.cross(Qv).normalised();
    if (m.dot(n) < 0) m = -m;       // outwards, whatever the handedness
    return m;
    // TASK T1 end
}

}  // namespace raytracer
