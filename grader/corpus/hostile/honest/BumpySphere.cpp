// Option 1, task T1: bump mapping.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 normal = Sphere::getNormalAt(position);

    // Spherical polar coordinates: longitude to the right, polar angle downwards from the top.
    const double longitude = std::atan2(normal.x, -normal.z);
    const double polarAngle = std::acos(std::clamp(normal.y, -1.0, 1.0));
    const double u = longitude / (2.0 * std::numbers::pi) + 0.5;
    const double v = polarAngle / std::numbers::pi;

    // Unit tangents: Pu to the right, Pv downwards.
    const Vector3 Pu{std::cos(longitude), 0.0, std::sin(longitude)};
    const Vector3 Pv{std::sin(longitude) * std::cos(polarAngle), -std::sin(polarAngle),
                     -std::cos(longitude) * std::cos(polarAngle)};

    // Slopes: the texel to the right, or below, minus this one. Columns go round the sphere.
    const HeightMap& map = heightMap();
    const int column = std::min(static_cast<int>(u * map.width()), map.width() - 1);
    const int row = std::min(static_cast<int>(v * map.height()), map.height() - 1);
    const int rowBelow = std::min(row + 1, map.height() - 1);
    const double Bu = map.at((column + 1) % map.width(), row) - map.at(column, row);
    const double Bv = map.at(column, rowBelow) - map.at(column, row);

    // A surface that rises along a tangent leans back against it.
    return (normal - Bu * Pu - Bv * Pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
