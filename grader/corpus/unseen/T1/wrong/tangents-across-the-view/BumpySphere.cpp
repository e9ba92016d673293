#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const Vector3 view = position.normalised();
    // Sideways and downwards as the viewer sees them.
    const Vector3 sideways = Vector3{0, 1, 0}.cross(view).normalised();
    const Vector3 pv = sideways.cross(n).normalised();
    const Vector3 pu = n.cross(pv);

    const HeightMap& m = heightMap();
    const double u = std::atan2(n.x, -n.z) / (2 * std::numbers::pi) + 0.5;
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const auto x = [&](int k) { return (static_cast<int>(u * m.width()) + k) % m.width(); };
    const auto y = [&](int k) {
        return std::min(static_cast<int>(v * m.height()) + k, m.height() - 1);
    };
    const double bu = m.at(x(1), y(0)) - m.at(x(0), y(0));
    const double bv = m.at(x(0), y(1)) - m.at(x(0), y(0));
    return (n - bu * pu - bv * pv).normalised();
}

}  // namespace raytracer
