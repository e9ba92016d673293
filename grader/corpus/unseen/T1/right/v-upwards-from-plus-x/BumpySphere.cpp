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
    const int across = heightMap().width(), up = heightMap().height();

    // spherical polar coordinates, u = 0 at +x, counted to the right as seen from outside
    double u = std::atan2(n.z, n.x) / (2.0 * std::numbers::pi);
    u = u < 0.0 ? u + 1.0 : u;
    const double v = 0.5 + std::asin(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;  // 1 at the top

    const double a = 2.0 * std::numbers::pi * u, b = std::numbers::pi * (v - 0.5);
    // F(u, v) = (cos a cos b, sin b, sin a cos b)
    const Vector3 Pu{-std::sin(a), 0.0, std::cos(a)};
    const Vector3 Pv{-std::cos(a) * std::sin(b), std::cos(b), -std::sin(a) * std::sin(b)};

    const int i = static_cast<int>(u * across) % across;
    const int j = std::min(static_cast<int>((1.0 - v) * up), up - 1);
    const double current = heightMap().at(i, j);
    const double below = heightMap().at(i, j == up - 1 ? j : j + 1);
    const double right = heightMap().at((i + 1) % across, j);
    const double Bu = current - right;  // against P_u
    const double Bv = current - below;  // along P_v
    return (n + n.cross(Pv) * Bu + n.cross(Pu) * Bv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
