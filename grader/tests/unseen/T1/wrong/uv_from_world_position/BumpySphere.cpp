#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

struct Spherical {
    double phi, theta;
    explicit Spherical(const Vector3& p) : phi(std::atan2(p.x, -p.z)), theta(std::acos(p.y / p.magnitude())) {}
    [[nodiscard]] double u() const { return phi / (2.0 * std::numbers::pi) + 0.5; }
    [[nodiscard]] double v() const { return theta / std::numbers::pi; }
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 normal = Sphere::getNormalAt(position);
    const Spherical s{position};
    const HeightMap& map = heightMap();
    const int column = std::clamp(static_cast<int>(s.u() * map.width()), 0, map.width() - 1);
    const int row = std::clamp(static_cast<int>(s.v() * map.height()), 0, map.height() - 1);
    const double b = map.at(column, row);
    const double bu = map.at((column + 1) % map.width(), row) - b;
    const double bv = map.at(column, std::min(row + 1, map.height() - 1)) - b;

    const Spherical t{normal};
    const Vector3 pu{std::cos(t.phi), 0.0, std::sin(t.phi)};
    return (normal - bu * pu - bv * normal.cross(pu)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
