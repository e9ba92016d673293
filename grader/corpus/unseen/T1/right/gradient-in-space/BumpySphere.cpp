#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {
double heightTowards(const HeightMap& map, const Vector3& direction) {
    const Vector3 d = direction.normalised();
    double u = std::atan2(d.x, d.z) / (2 * std::numbers::pi);
    u -= std::floor(u);
    const double v = std::acos(std::clamp(d.y, -1.0, 1.0)) / std::numbers::pi;
    const double x = u * map.width(), y = v * (map.height() - 1);
    const int c = static_cast<int>(x), r = std::min(static_cast<int>(y), map.height() - 2);
    const double fx = x - c, fy = y - r;
    const int c0 = c % map.width(), c1 = (c + 1) % map.width();
    return std::lerp(std::lerp(map.at(c0, r), map.at(c1, r), fx), std::lerp(map.at(c0, r + 1), map.at(c1, r + 1), fx), fy);
}
}  // namespace
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double e = 1.5 / std::max(heightMap().width(), heightMap().height());
    const auto along = [&](const Vector3& axis) {
        return (heightTowards(heightMap(), n + axis * e) - heightTowards(heightMap(), n - axis * e)) / (2 * e);
    };
    Vector3 g{along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})};
    g -= n * g.dot(n);
    return (n - g * 0.02).normalised();
}
}  // namespace raytracer
