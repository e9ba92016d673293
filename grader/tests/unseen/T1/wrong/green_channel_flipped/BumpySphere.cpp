#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

/// Tangent, bitangent, normal as the columns of a matrix.
struct Tbn {
    std::array<Vector3, 3> columns;
    [[nodiscard]] Vector3 operator*(const Vector3& t) const {
        return columns[0] * t.x + columns[1] * t.y + columns[2] * t.z;
    }
};

/// Height map to tangent-space normal, as a normal map would hold it.
Vector3 tangentSpaceNormal(double dhdx, double dhdy) {
    return Vector3{-dhdx, dhdy, 1.0}.normalised();  // y is up in tangent space
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double phi = std::atan2(n.x, -n.z);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));

    const auto& map = heightMap();
    const int x = std::min(static_cast<int>((phi / (2 * std::numbers::pi) + 0.5) * map.width()), map.width() - 1);
    const int y = std::min(static_cast<int>(theta / std::numbers::pi * map.height()), map.height() - 1);
    const double h = map.at(x, y);
    const double dhdx = map.at((x + 1) % map.width(), y) - h;
    const double dhdy = map.at(x, std::min(y + 1, map.height() - 1)) - h;

    const Tbn tbn{{Vector3{std::cos(phi), 0.0, std::sin(phi)},
                   Vector3{std::sin(phi) * std::cos(theta), -std::sin(theta), -std::cos(phi) * std::cos(theta)},
                   n}};
    return (tbn * tangentSpaceNormal(dhdx, dhdy)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
