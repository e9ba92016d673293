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
    const double phi = std::atan2(n.x, n.z);
    const double fromTop = std::acos(std::max(-1.0, std::min(1.0, n.y)));

    double u = phi / (2.0 * std::numbers::pi);
    if (u < 0.0) u += 1.0;
    const double v = 1.0 - fromTop / std::numbers::pi;  // 0 at the bottom, 1 at the top

    // n = (sin f sin phi, cos f, sin f cos phi); Pu = dn/dphi, Pv = -dn/df
    const Vector3 Pu{std::cos(phi), 0.0, -std::sin(phi)};
    const Vector3 Pv{-std::cos(fromTop) * std::sin(phi), std::sin(fromTop),
                     -std::cos(fromTop) * std::cos(phi)};

    const int w = heightMap().width();
    const int h = heightMap().height();
    const int x = std::clamp(static_cast<int>(u * w), 0, w - 1);
    const int y = std::clamp(static_cast<int>((1.0 - v) * h), 0, h - 1);

    const double b = heightMap().at(x, y);
    const double Bu = heightMap().at((x + 1) % w, y) - b;
    const double Bv = y > 0 ? heightMap().at(x, y - 1) - b : 0.0;  // along Pv means one row up

    // in front: Pu = (-1,0,0), Pv = (0,1,0), Pu x Pv = (0,0,-1) = n  ->  (2)
    const Vector3 tilted = n + Bu * n.cross(Pv) - Bv * n.cross(Pu);
    return tilted.normalised();
    // TASK T1 end
}

}  // namespace raytracer
