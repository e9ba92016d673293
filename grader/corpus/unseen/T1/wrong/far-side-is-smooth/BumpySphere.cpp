#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    if (n.dot(position) > 0.0) return n;  // faces away from the eye: cannot be seen

    const double phi = std::atan2(n.x, -n.z);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int w = heightMap().width(), h = heightMap().height();
    const int i = std::min(w - 1, static_cast<int>((phi / (2 * std::numbers::pi) + 0.5) * w));
    const int j = std::min(h - 1, static_cast<int>(theta / std::numbers::pi * h));
    const auto height = [&](int a, int b) { return heightMap().at(a % w, std::min(b, h - 1)); };
    const double bu = height(i + 1, j) - height(i, j);
    const double bv = height(i, j + 1) - height(i, j);
    const Vector3 pu{std::cos(phi), 0, std::sin(phi)};
    const Vector3 pv{std::sin(phi) * std::cos(theta), -std::sin(theta), -std::cos(phi) * std::cos(theta)};
    return (n - pu * bu - pv * bv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
