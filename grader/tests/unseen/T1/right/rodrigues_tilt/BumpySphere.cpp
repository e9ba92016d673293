#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace raytracer {
namespace {

struct Angles {
    double azimuth;
    double zenith;

    static Angles of(const Vector3& n) {
        return {std::atan2(-n.x, n.z) + std::numbers::pi, std::atan2(std::hypot(n.x, n.z), n.y)};
    }
    [[nodiscard]] Vector3 eastwards() const { return {std::cos(azimuth), 0.0, std::sin(azimuth)}; }
    [[nodiscard]] Vector3 southwards() const {
        return {std::sin(azimuth) * std::cos(zenith), -std::sin(zenith), -std::cos(azimuth) * std::cos(zenith)};
    }
};

/// Rodrigues' rotation of v about the unit axis k.
Vector3 rotated(const Vector3& v, const Vector3& k, double angle) {
    return v * std::cos(angle) + k.cross(v) * std::sin(angle) + k * (k.dot(v) * (1.0 - std::cos(angle)));
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const Angles angles = Angles::of(n);
    const auto texel = [&map = heightMap()](int c, int r) -> std::optional<double> {
        if (r >= map.height()) return std::nullopt;
        return map.at(c % map.width(), r);
    };
    const int column = static_cast<int>(angles.azimuth / (2.0 * std::numbers::pi) * heightMap().width()) % heightMap().width();
    const int row = std::min(static_cast<int>(angles.zenith / std::numbers::pi * heightMap().height()), heightMap().height() - 1);
    const double h = texel(column, row).value();

    // The uphill direction, and how steep it is.
    const Vector3 uphill = (texel(column + 1, row).value() - h) * angles.eastwards() +
                           (texel(column, row + 1).value_or(h) - h) * angles.southwards();
    const double steepness = uphill.magnitude();
    if (steepness == 0.0) return n;
    // Turn away from uphill: from n towards -uphill, by the angle of the slope.
    const Vector3 axis = n.cross(-uphill).normalised();
    return rotated(n, axis, std::atan(steepness)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
