#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

// n' = n - g^ij (dh/dx^i) P_j holds in ANY coordinates. For the fun of it, in the oblique
// p = lambda + theta, q = lambda - theta.
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    constexpr double pi = std::numbers::pi;
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double st = std::max(std::sin(theta), 1e-7);
    const Vector3 Pl{std::cos(lambda) * st, 0, std::sin(lambda) * st};
    const Vector3 Pt{std::sin(lambda) * std::cos(theta), -st, -std::cos(lambda) * std::cos(theta)};
    const Vector3 Pp = (Pl + Pt) / 2, Pq = (Pl - Pt) / 2;

    const HeightMap& map = heightMap();
    const int W = map.width(), H = map.height();
    const int i = std::min(int((lambda + pi) / (2 * pi) * W), W - 1);
    const int j = std::min(int(theta / pi * H), H - 1);
    const double h0 = map.at(i, j);
    constexpr double depth = 0.02;
    const double hl = depth * (map.at((i + 1) % W, j) - h0) * W / (2 * pi);
    const double ht = j + 1 < H ? depth * (map.at(i, j + 1) - h0) * H / pi : 0.0;
    const double hp = (hl + ht) / 2, hq = (hl - ht) / 2;

    const double E = Pp.dot(Pp), F = Pp.dot(Pq), G = Pq.dot(Pq), det = E * G - F * F;
    const double cp = (G * hp - F * hq) / det;
    const double cq = (E * hq - F * hp) / det;
    return (n - Pp * cp - Pq * cq).normalised();
}

}  // namespace raytracer
