#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    // from Java, where a byte needs & 0xFF
    const auto grey = [this](int x, int y) {
        const int w = heightMap().width(), h = heightMap().height();
        return static_cast<std::uint8_t>(std::lround(heightMap().at((x + w) % w, y < h ? y : h - 1) / kBumpFactor * 255));
    };
    const auto diff = [](std::uint8_t a, std::uint8_t b) { return ((a - b) & 0xFF) / 255.0 * kBumpFactor; };

    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z);
    const double pol = std::acos(std::min(1.0, std::max(-1.0, n.y)));
    const int x = std::min(heightMap().width() - 1, int((lon + std::numbers::pi) / (2 * std::numbers::pi) * heightMap().width()));
    const int y = std::min(heightMap().height() - 1, int(pol / std::numbers::pi * heightMap().height()));
    const double bu = diff(grey(x + 1, y), grey(x, y));
    const double bv = diff(grey(x, y + 1), grey(x, y));
    const Vector3 pu(std::cos(lon), 0, std::sin(lon));
    const Vector3 pv = n.cross(pu);
    return (n - pu * bu - pv * bv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
