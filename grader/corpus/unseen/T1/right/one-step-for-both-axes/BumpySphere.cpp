#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const double pi = std::numbers::pi;
    const int W = heightMap().width(), H = heightMap().height();
    const auto B = [&](double u, double v) {
        const double x = (u - std::floor(u)) * (W - 1), y = std::clamp(v, 0.0, 1.0) * (H - 1);
        const int i = int(x) % W, j = std::min(int(y), H - 2);
        const double f = x - std::floor(x), g = y - j;
        return (heightMap().at(i, j) * (1 - f) + heightMap().at((i + 1) % W, j) * f) * (1 - g) +
               (heightMap().at(i, j + 1) * (1 - f) + heightMap().at((i + 1) % W, j + 1) * f) * g;
    };
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double u = 0.5 + lambda / (2 * pi), v = theta / pi, e = 1.0 / W;
    const double bu = (B(u + e, v) - B(u - e, v)) / (2 * e), bv = (B(u, v + e) - B(u, v - e)) / (2 * e);
    const Vector3 pu{std::cos(lambda), 0, std::sin(lambda)};
    const Vector3 pv{std::cos(theta) * std::sin(lambda), -std::sin(theta), -std::cos(theta) * std::cos(lambda)};
    return (n - pu * (bu * 0.01) - pv * (bv * 0.01)).normalised();
    // TASK T1 end
}
}  // namespace raytracer
