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
    const double lon = std::atan2(n.x, -n.z);
    const double lat = std::asin(std::clamp(n.y, -1.0, 1.0));   // -90 .. 90 degrees, up is positive
    const double u = lon / (2 * std::numbers::pi) + 0.5;
    const double v = lat / std::numbers::pi + 0.5;

    const int W = heightMap().width();
    const int Hh = heightMap().height();
    const int c = std::min((int)(u * W), W - 1);
    const int r = std::min((int)(v * Hh), Hh - 1);
    const double Bu = heightMap().at((c + 1) % W, r) - heightMap().at(c, r);
    const double Bv = heightMap().at(c, std::min(r + 1, Hh - 1)) - heightMap().at(c, r);

    const Vector3 Pu{std::cos(lon), 0, std::sin(lon)};
    const Vector3 Pv{-std::sin(lat) * std::sin(lon), std::cos(lat), std::sin(lat) * std::cos(lon)};
    // Pu right, Pv up
    return (n - Bu * n.cross(Pv) + Bv * n.cross(Pu)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
