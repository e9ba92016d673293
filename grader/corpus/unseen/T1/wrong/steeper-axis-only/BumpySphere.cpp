#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const double pi = std::numbers::pi;
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(n.x, -n.z);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const HeightMap& map = heightMap();
    const int w = map.width(), h = map.height();
    double u = 0.5 + lambda / (2 * pi);
    double v = theta / pi;

    int c = std::min(w - 1, static_cast<int>(u * w));
    int r = std::min(h - 1, static_cast<int>(v * h));

    const auto B = [&](int x, int y) { return map.at(x, y); };
    const int c2 = (c + 1) % w;
    const int r2 = std::min(r + 1, h - 1);
    double bu = B(c2, r) - B(c, r);
    double bv = B(c, r2) - B(c, r);
    if (std::abs(bu) > std::abs(bv)) bv = 0; else bu = 0;
    Vector3 pu{std::cos(lambda), 0, std::sin(lambda)};
    Vector3 pv{std::cos(theta) * std::sin(lambda), -std::sin(theta), -std::cos(theta) * std::cos(lambda)};

    const Vector3 out = (n - pu * bu - pv * bv).normalised();

    return out;
    // TASK T1 end
}
}  // namespace raytracer
