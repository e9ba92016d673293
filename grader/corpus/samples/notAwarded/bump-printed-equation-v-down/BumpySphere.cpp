#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const auto n = Sphere::getNormalAt(position);
    const auto polar = std::acos(std::clamp(n.y, -1.0, 1.0));
    const auto azimuth = std::atan2(n.x, -n.z);
    // Derivatives of the point by u and by v, not normalised.
    const Vector3 Fu{std::sin(polar) * std::cos(azimuth), 0.0, std::sin(polar) * std::sin(azimuth)};
    const Vector3 Fv{std::cos(polar) * std::sin(azimuth), -std::sin(polar), -std::cos(polar) * std::cos(azimuth)};
    const auto B = [this](int i, int j) {
        return heightMap().at(i % heightMap().width(), std::min(j, heightMap().height() - 1));
    };
    const int i = static_cast<int>((azimuth / (2 * std::numbers::pi) + 0.5) * (heightMap().width() - 1));
    const int j = static_cast<int>(polar / std::numbers::pi * (heightMap().height() - 1));
    const double Bu = B(i, j) - B(i + 1, j), Bv = B(i, j) - B(i, j + 1);
    return (n + (n.cross(Fv)) * Bu + (n.cross(Fu)) * Bv).normalised();
}

}  // namespace raytracer
