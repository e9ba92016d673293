// was: bumpySphere.js
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const auto PI = std::numbers::pi;
    const auto self = this;

    const auto clamp = [](double x) { return x > 1 ? 1. : x < -1 ? -1. : x; };

    // const sample = (x, y) => ...   y counts from the BOTTOM, like in WebGL
    const auto sample = [=](int x, int y) {
        const auto w = self->heightMap().width(), h = self->heightMap().height();
        const auto col = (x % w + w) % w;
        const auto row = h - 1 - (y < 0 ? 0 : y >= h ? h - 1 : y);
        return self->heightMap().at(col, row);
    };

    const auto n = Sphere::getNormalAt(position);
    const struct { double lon, lat; } angle = {std::atan2(n.x, -n.z), PI / 2 - std::acos(clamp(n.y))};
    const struct { double u, v; } uv = {angle.lon / (2 * PI) + 0.5, angle.lat / PI + 0.5};

    const auto px = int(std::floor(uv.u * self->heightMap().width()));
    // texel rows are half open the other way round when counted from the bottom
    const auto py = int(std::ceil(uv.v * self->heightMap().height())) - 1;

    const auto dBdu = sample(px + 1, py) - sample(px, py);
    const auto dBdv = sample(px, py + 1) - sample(px, py);  // one texel UP

    const Vector3 Pu(std::cos(angle.lon), 0, std::sin(angle.lon));
    const Vector3 Pv(-std::sin(angle.lon) * std::sin(angle.lat), std::cos(angle.lat),
                     std::cos(angle.lon) * std::sin(angle.lat));
    // Pu x Pv = -n here: equation (3)
    const auto bumped = n - dBdu * n.cross(Pv) + dBdv * n.cross(Pu);
    return bumped.normalised();
    // TASK T1 end
}

}  // namespace raytracer
