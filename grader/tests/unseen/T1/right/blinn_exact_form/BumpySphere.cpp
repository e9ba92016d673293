#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

// Blinn 1978, equations as in the paper, tangents with their own lengths:
//   N' = N + D,   D = ( Bu (N x Pv) - Bv (N x Pu) ) / |N|,   N = Pu x Pv
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    constexpr double kScale = 0.004;  // world units for a height of 1, radius 1
    const Vector3 p = (position - centre()) / radius();
    const double lambda = std::atan2(p.x, -p.z);
    const double theta = std::acos(std::clamp(p.y, -1.0, 1.0));
    const double st = std::sin(theta), ct = std::cos(theta);
    const double sl = std::sin(lambda), cl = std::cos(lambda);

    // dP/du and dP/dv for P = (sl st, ct, -cl st), u = lambda / 2 pi + 1/2, v = theta / pi
    const Vector3 Pu = Vector3{cl * st, 0.0, sl * st} * (2.0 * std::numbers::pi);
    const Vector3 Pv = Vector3{sl * ct, -st, -cl * ct} * std::numbers::pi;
    const Vector3 N = Pu.cross(Pv);
    const double lengthOfN = N.magnitude();
    if (lengthOfN < 1e-9) return Sphere::getNormalAt(position);  // a pole: no tangents there

    const HeightMap& F = heightMap();
    const int i = std::min(static_cast<int>((lambda / (2.0 * std::numbers::pi) + 0.5) * F.width()), F.width() - 1);
    const int j = std::min(static_cast<int>(theta / std::numbers::pi * F.height()), F.height() - 1);
    // Slopes by u and v, which go from 0 to 1 over the whole map.
    const double Bu = kScale * F.width() * (F.at((i + 1) % F.width(), j) - F.at(i, j));
    const double Bv = kScale * F.height() * (F.at(i, std::min(j + 1, F.height() - 1)) - F.at(i, j));

    const Vector3 D = (Bu * N.cross(Pv) - Bv * N.cross(Pu)) / lengthOfN;
    return (N + D).normalised();
    // TASK T1 end
}

}  // namespace raytracer
