#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

// Blinn 1978, eq. (4): N' = N + [ F_u (N x P_v) - F_v (N x P_u) ] / |N|, nothing normalised early.
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    constexpr double pi = std::numbers::pi;
    const double r = radius();
    const Vector3 p = Sphere::getNormalAt(position);
    const double lambda = std::atan2(p.x, -p.z);
    const double theta = std::acos(std::clamp(p.y, -1.0, 1.0));
    const double st = std::max(std::sin(theta), 1e-9), ct = std::cos(theta);
    const double sl = std::sin(lambda), cl = std::cos(lambda);

    // P(u, v) = centre + r (sin l sin t, cos t, -cos l sin t),  l = 2 pi u - pi,  t = pi v
    const Vector3 Pu = Vector3{cl * st, 0, sl * st} * (2 * pi * r);
    const Vector3 Pv = Vector3{sl * ct, -st, -cl * ct} * (pi * r);
    const Vector3 N = Pu.cross(Pv);

    const HeightMap& F = heightMap();
    const int W = F.width(), H = F.height();
    const int i = std::clamp(int((lambda + pi) / (2 * pi) * W), 0, W - 1);
    const int j = std::clamp(int(theta / pi * H), 0, H - 1);
    const double depth = 0.01 * r;  // world units for each unit of height
    const double Fu = depth * W * (F.at((i + 1) % W, j) - F.at(i, j));
    const double Fv = j + 1 < H ? depth * H * (F.at(i, j + 1) - F.at(i, j)) : 0.0;

    const Vector3 D = (Fu * N.cross(Pv) - Fv * N.cross(Pu)) / N.magnitude();
    return (N + D).normalised();
}

}  // namespace raytracer
