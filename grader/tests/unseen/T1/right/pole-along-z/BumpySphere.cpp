#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
// The parametrisation from the mathematics lectures: z is the axis.
//   F(u, v) = (sin t cos p, sin t sin p, cos t),  p = 2 pi u, t = pi v
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    using std::numbers::pi;
    const Vector3 n = (position - centre()).normalised();
    const double t = std::acos(std::clamp(n.z, -1.0, 1.0));
    double p = std::atan2(n.y, n.x);
    if (p < 0) p += 2 * pi;

    const Vector3 pu{-std::sin(p), std::cos(p), 0};
    const Vector3 pv{std::cos(t) * std::cos(p), std::cos(t) * std::sin(p), -std::sin(t)};

    const int W = heightMap().width(), H = heightMap().height();
    const int i = std::clamp(int(p / (2 * pi) * W), 0, W - 1);
    const int j = std::clamp(int(t / pi * H), 0, H - 1);
    const double here = heightMap().at(i, j);
    const double bu = heightMap().at((i + 1) % W, j) - here;
    const double bv = j + 1 < H ? heightMap().at(i, j + 1) - here : 0.0;

    // Pv x Pu = -n here with this cross product ... so ask instead of guessing:
    const double hand = pu.cross(pv).dot(n) > 0 ? 1.0 : -1.0;
    return (n + hand * (bu * n.cross(pv) - bv * n.cross(pu))).normalised();
}
}  // namespace raytracer
