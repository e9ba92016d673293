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
    const double s = std::sqrt(std::max(1e-12, 1.0 - n.y * n.y));  // sine of the polar angle
    const double c = std::sqrt(std::max(0.0, 1.0 - s * s));       // its cosine
    const double sl = n.x / s, cl = -n.z / s;
    const Vector3 Pu{cl, 0.0, sl};
    const Vector3 Pv{sl * c, -s, -cl * c};
    const double u = 0.5 + std::atan2(sl, cl) / (2.0 * std::numbers::pi);
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const int W = heightMap().width(), H = heightMap().height();
    const int i = std::min(static_cast<int>(u * W), W - 1);
    const int j = std::min(static_cast<int>(v * H), H - 1);
    const double b = heightMap().at(i, j);
    const double Bu = heightMap().at(i + 1 < W ? i + 1 : 0, j) - b;
    const double Bv = heightMap().at(i, j + 1 < H ? j + 1 : j) - b;
    return (n - Bu * Pu - Bv * Pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
