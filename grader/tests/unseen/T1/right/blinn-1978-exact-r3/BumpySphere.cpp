// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    // Blinn 1978, section 3. P(u,v) on the UNIT sphere (radius only changes strength)
    //   P = ( sin a sin b, cos b, -cos a sin b ),  a = 2 pi u - pi, b = pi v
    const Vector3 s = Sphere::getNormalAt(position);
    const double a = std::atan2(s.x, -s.z);
    const double b = std::acos(std::clamp(s.y, -1.0, 1.0));
    const double sb = std::max(std::sin(b), 1e-3);  // never quite zero at the poles
    const Vector3 Pu{sb * std::cos(a), 0, sb * std::sin(a)};
    const Vector3 Pv{std::sin(a) * std::cos(b), -std::sin(b), -std::cos(a) * std::cos(b)};
    const Vector3 N = sb * s;                 // = Pu x Pv
    auto F = [this](int i, int j) {
        const auto& m = heightMap();
        return 0.25 * m.at(i % m.width(), std::min(j, m.height() - 1));
    };
    const int i = static_cast<int>((a / (2 * std::numbers::pi) + 0.5) * heightMap().width()) % heightMap().width();
    const int j = std::min(static_cast<int>(b / std::numbers::pi * heightMap().height()), heightMap().height() - 1);
    const double Fu = F(i + 1, j) - F(i, j), Fv = F(i, j + 1) - F(i, j);
    const Vector3 D = Fu * s.cross(Pv) - Fv * s.cross(Pu);
    return (N + D).normalised();
    // TASK T1 end
}

}  // namespace raytracer
