#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

template <class Map> class Bilinear {
    const Map& map_;
    double t(int c, int r) const {
        return map_.at((c + map_.width()) % map_.width(), std::clamp(r, 0, map_.height() - 1));
    }
public:
    explicit Bilinear(const Map& m) : map_(m) {}
    double operator()(double u, double v) const {
        u -= std::floor(u);
        const double x = u * map_.width() - .5, y = v * map_.height() - .5;
        const int i = int(std::floor(x)), j = int(std::floor(y));
        const double a = x - i, b = y - j;
        return (1 - b) * ((1 - a) * t(i, j) + a * t(i + 1, j)) + b * ((1 - a) * t(i, j + 1) + a * t(i + 1, j + 1));
    }
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    constexpr double pi = std::numbers::pi;
    const Vector3 n = Sphere::getNormalAt(position);
    const double u0 = std::atan2(n.z, n.x) / (2 * pi);
    const double v0 = 1 - std::acos(std::clamp(n.y, -1., 1.)) / pi;  // from the bottom up

    const Bilinear height{heightMap()};
    const auto displaced = [&](double u, double v) {
        const Vector3 d{std::cos(2 * pi * u) * std::sin(pi * v), -std::cos(pi * v),
                        std::sin(2 * pi * u) * std::sin(pi * v)};
        return d * (1 + 0.004 * height(u, 1 - v));
    };
    const double e = 2e-4;
    const Vector3 du = displaced(u0 + e, v0) - displaced(u0 - e, v0);
    const Vector3 dv = displaced(u0, v0 + e) - displaced(u0, v0 - e);
    const Vector3 across = du.cross(dv);
    if (across.magnitude() < 1e-14) return n;
    const Vector3 normal = across.normalised();
    const double out = normal.dot(n);
    // Keep the tilt, but make sure that it is turned to the outside.
    const Vector3 tilt = normal - out * n;
    return (std::abs(out) * n + tilt).normalised();
    // TASK T1 end
}

}  // namespace raytracer
