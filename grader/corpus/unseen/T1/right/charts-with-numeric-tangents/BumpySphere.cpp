// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace raytracer {

namespace {
struct Globe {
    static constexpr double pi = std::numbers::pi;
    Vector3 operator()(double u, double v) const {
        const double a = 2 * pi * (u - 0.5), b = pi * v;
        return {std::sin(a) * std::sin(b), std::cos(b), -std::cos(a) * std::sin(b)};
    }
    std::pair<double, double> inverse(const Vector3& n) const {
        // not quite at the poles, where the chart has no tangent along u
        const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / pi;
        return {std::atan2(n.x, -n.z) / (2 * pi) + 0.5, std::clamp(v, 1e-4, 1 - 1e-4)};
    }
};

template <typename Curve>
Vector3 derivative(Curve&& curve, double at) {
    constexpr double step = 1e-5;
    return (curve(at + step) - curve(at - step)).normalised();
}
}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Globe globe;
    const Vector3 n = (position - centre()) / (position - centre()).magnitude();
    const auto [u, v] = globe.inverse(n);
    const Vector3 pu = derivative([&](double t) { return globe(t, v); }, u);
    const Vector3 pv = derivative([&](double t) { return globe(u, t); }, v);

    const int w = heightMap().width(), h = heightMap().height();
    const int c = std::clamp(int(u * w), 0, w - 1), r = std::clamp(int(v * h), 0, h - 1);
    const double height = heightMap().at(c, r);
    const double bu = height - heightMap().at((c + w - 1) % w, r);
    const double bv = height - heightMap().at(c, std::max(r - 1, 0));

    // surface tangents of the relief, and their normal; turned outwards
    const Vector3 m = (pu + bu * n).cross(pv + bv * n);
    return (m.dot(n) < 0 ? -m : m).normalised();
    // TASK T1 end
}

}  // namespace raytracer
