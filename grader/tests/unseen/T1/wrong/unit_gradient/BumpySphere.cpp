#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 N = Sphere::getNormalAt(position);
    const double phi = std::atan2(N.x, -N.z), theta = std::acos(std::clamp(N.y, -1.0, 1.0));
    const Vector3 Pu{std::cos(phi), 0, std::sin(phi)};
    const Vector3 Pv = N.cross(Pu);

    const HeightMap& B = heightMap();
    int col = static_cast<int>((phi / (2 * std::numbers::pi) + 0.5) * B.width());
    int row = static_cast<int>(theta / std::numbers::pi * B.height());
    col = std::min(col, B.width() - 1);
    row = std::min(row, B.height() - 1);
    const double Bu = B.at((col + 1) % B.width(), row) - B.at(col, row);
    const double Bv = B.at(col, std::min(row + 1, B.height() - 1)) - B.at(col, row);

    Vector3 gradient = Bu * Pu + Bv * Pv;
    // Heights go up to 5, which would be far too strong: use the direction, and one strength.
    constexpr double kStrength = 0.5;
    if (gradient.magnitude() > 1e-9) gradient = gradient.normalised() * kStrength;
    return (N - gradient).normalised();
    // TASK T1 end
}

}  // namespace raytracer
