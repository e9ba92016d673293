#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
// Longitude counted like an astronomer looking out from the centre: to the left.
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const double pi = std::numbers::pi;
    const Vector3 n = Sphere::getNormalAt(position);
    const double phi =
        std::atan2(n.z, n.x) > 0 ? 2 * pi - std::atan2(n.z, n.x) : -std::atan2(n.z, n.x);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double u = phi / (2 * pi), v = theta / pi;
    // F = (sin t cos p, cos t, -sin t sin p)
    const Vector3 Pu =
        Vector3{-std::sin(theta) * std::sin(phi), 0, -std::sin(theta) * std::cos(phi)};
    const Vector3 Pv{std::cos(theta) * std::cos(phi), -std::sin(theta),
                     -std::cos(theta) * std::sin(phi)};
    const int W = heightMap().width(), H = heightMap().height();
    int i = static_cast<int>(u * (W - 1)), j = static_cast<int>(v * (H - 1));
    i = std::clamp(i, 0, W - 2);
    j = std::clamp(j, 0, H - 2);
    const double Bu = heightMap().at(i, j) - heightMap().at(i + 1, j);  // step 3, as printed
    const double Bv = heightMap().at(i, j) - heightMap().at(i, j + 1);
    // Pu is left as long as the derivative is: sin(theta) weakens u towards the poles.
    return (n + Bu * Pu + Bv * Pv).normalised();
}
}  // namespace raytracer
