#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double phi = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int w = heightMap().width(), h = heightMap().height();
    const int c = std::min(w - 1, int((phi / std::numbers::pi + 1) / 2 * w)), r = std::min(h - 1, int(theta / std::numbers::pi * h));
    const double bu = heightMap().at((c + 1) % w, r) - heightMap().at(c, r);
    const double bv = r + 1 < h ? heightMap().at(c, r + 1) - heightMap().at(c, r) : 0;
    const double phi2 = ((c + 0.5) / w * 2 - 1) * std::numbers::pi, theta2 = (r + 0.5) / h * std::numbers::pi;
    const Vector3 pu{std::cos(phi2), 0, std::sin(phi2)};
    const Vector3 pv{std::cos(theta2) * std::sin(phi2), -std::sin(theta2), -std::cos(theta2) * std::cos(phi2)};
    return (n - pu * bu - pv * bv).normalised();
}

}  // namespace raytracer
