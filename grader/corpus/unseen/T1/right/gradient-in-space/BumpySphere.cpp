// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace raytracer {

namespace {

constexpr double kTau = 2.0 * std::numbers::pi;

double heightInDirection(const HeightMap& map, const Vector3& p) {
    const double u = std::atan2(p.x, -p.z) / kTau + 0.5;
    const double v = std::acos(std::clamp(p.y / p.magnitude(), -1.0, 1.0)) / std::numbers::pi;
    const double x = u * map.width() - 0.5;
    const double y = std::clamp(v * map.height() - 0.5, 0.0, map.height() - 1.0);
    const int i = static_cast<int>(std::floor(x));
    const int j = std::min(static_cast<int>(y), map.height() - 2);
    const double a = x - i;
    const double b = y - j;
    const auto texel = [&map](int c, int r) { return map.at((c + map.width()) % map.width(), r); };
    return (1 - a) * (1 - b) * texel(i, j) + a * (1 - b) * texel(i + 1, j) +
           (1 - a) * b * texel(i, j + 1) + a * b * texel(i + 1, j + 1);
}

Vector3 gradient(const std::function<double(const Vector3&)>& f, const Vector3& p) {
    constexpr double e = 1e-5;
    const auto slope = [&](const Vector3& d) { return (f(p + d * e) - f(p - d * e)) / (2 * e); };
    return {slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})};
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 onUnitSphere = Sphere::getNormalAt(position);
    const double k = std::numbers::pi / heightMap().height();  // one texel downwards is this long
    const auto outside = [&](const Vector3& p) {
        return p.magnitude() - k * heightInDirection(heightMap(), p);
    };
    return gradient(outside, onUnitSphere).normalised();
    // TASK T1 end
}

}  // namespace raytracer
