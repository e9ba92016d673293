#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double sinTheta = std::sin(theta);
    // x = sin(theta) sin(phi)
    const double phi = sinTheta > 1e-12 ? std::asin(std::clamp(n.x / sinTheta, -1.0, 1.0)) : 0.0;

    const double u = 0.5 + phi / (2.0 * std::numbers::pi);
    const double v = theta / std::numbers::pi;
    const auto width = heightMap().width();
    const auto height = heightMap().height();
    const auto clampTo = [](double value, int count) { return std::clamp(static_cast<int>(value * count), 0, count - 1); };
    const int i = clampTo(u, width);
    const int j = clampTo(v, height);
    const double dU = heightMap().at((i + 1) % width, j) - heightMap().at(i, j);
    const double dV = heightMap().at(i, std::min(j + 1, height - 1)) - heightMap().at(i, j);

    const double side = n.z > 0.0 ? -1.0 : 1.0;  // seen from behind, phi grows to the left
    const Vector3 Pu{side * std::cos(phi), 0.0, std::sin(phi)};
    const Vector3 Pv{std::sin(phi) * std::cos(theta), -std::sin(theta), -side * std::cos(phi) * std::cos(theta)};
    return (n - dU * Pu - dV * Pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
