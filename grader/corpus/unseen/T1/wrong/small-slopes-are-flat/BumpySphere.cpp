#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

constexpr double kFlat = 0.1;

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 normal = Sphere::getNormalAt(position);
    const double longitude = std::atan2(normal.x, -normal.z);
    const double polarAngle = std::acos(std::clamp(normal.y, -1.0, 1.0));
    const HeightMap& map = heightMap();
    const int column = std::min(static_cast<int>((longitude / (2.0 * std::numbers::pi) + 0.5) * map.width()), map.width() - 1);
    const int row = std::min(static_cast<int>(polarAngle / std::numbers::pi * map.height()), map.height() - 1);
    const double Bu = map.at((column + 1) % map.width(), row) - map.at(column, row);
    const double Bv = map.at(column, std::min(row + 1, map.height() - 1)) - map.at(column, row);

    // Nothing to tilt: spare the trigonometry.
    if (std::abs(Bu) < kFlat && std::abs(Bv) < kFlat) return normal;

    const Vector3 Pu{std::cos(longitude), 0.0, std::sin(longitude)};
    const Vector3 Pv{std::sin(longitude) * std::cos(polarAngle), -std::sin(polarAngle), -std::cos(longitude) * std::cos(polarAngle)};
    return (normal + Bu * normal.cross(Pv) - Bv * normal.cross(Pu)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
