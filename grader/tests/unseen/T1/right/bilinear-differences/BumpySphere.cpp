// Smoothed bumps: the forward differences of the four texels around the point, interpolated.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const auto n = Sphere::getNormalAt(position);
    const auto& map = heightMap();
    const int w = map.width(), h = map.height();

    // clamps rows, wraps columns
    const auto B = [&](int column, int row) {
        return map.at((column + w) % w, std::clamp(row, 0, h - 1));
    };
    const auto dBu = [&](int column, int row) { return B(column + 1, row) - B(column, row); };
    const auto dBv = [&](int column, int row) { return B(column, row + 1) - B(column, row); };

    const double lon = std::atan2(n.x, -n.z), pol = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double x = (lon / (2 * std::numbers::pi) + 0.5) * w - 0.5;
    const double y = pol / std::numbers::pi * h - 0.5;
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));

    const auto blend = [&](const auto& slope) {
        return std::lerp(std::lerp(slope(i, j), slope(i + 1, j), x - i),
                         std::lerp(slope(i, j + 1), slope(i + 1, j + 1), x - i), y - j);
    };

    const Vector3 Pu{std::cos(lon), 0, std::sin(lon)};
    const Vector3 Pv{std::sin(lon) * std::cos(pol), -std::sin(pol), -std::cos(lon) * std::cos(pol)};
    return (n + blend(dBu) * n.cross(Pv) - blend(dBv) * n.cross(Pu)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
