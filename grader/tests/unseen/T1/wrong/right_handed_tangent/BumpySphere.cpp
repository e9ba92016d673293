#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    // x = sin(phi) sin(theta), y = cos(theta), z = -cos(phi) sin(theta)
    const double phi = std::atan2(n.x, -n.z);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));

    // d/dphi and d/dtheta
    const Vector3 dPhi{std::cos(phi), 0.0, -std::sin(phi)};
    const Vector3 dTheta{std::sin(phi) * std::cos(theta), -std::sin(theta), -std::cos(phi) * std::cos(theta)};

    const HeightMap& m = heightMap();
    const double u = phi / (2.0 * std::numbers::pi) + 0.5;
    const double v = theta / std::numbers::pi;
    const int c = std::min(int(u * m.width()), m.width() - 1);
    const int r = std::min(int(v * m.height()), m.height() - 1);
    const int cNext = c + 1 == m.width() ? 0 : c + 1;
    const int rNext = r + 1 == m.height() ? r : r + 1;

    const double bPhi = m.at(cNext, r) - m.at(c, r);
    const double bTheta = m.at(c, rNext) - m.at(c, r);
    return (n - bPhi * dPhi - bTheta * dTheta).normalised();
    // TASK T1 end
}

}  // namespace raytracer
