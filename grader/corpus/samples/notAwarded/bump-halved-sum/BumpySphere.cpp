#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double phi = std::atan2(n.z, n.x) + std::numbers::pi;
    const int W = heightMap().width(), H = heightMap().height();
    const int i = std::min(int(phi / (2 * std::numbers::pi) * W), W - 1), j = std::min(int(theta / std::numbers::pi * H), H - 1);
    const double bu = heightMap().at((i + 1) % W, j) - heightMap().at(i, j);
    const double bv = heightMap().at(i, std::min(j + 1, H - 1)) - heightMap().at(i, j);
    const Vector3 pu{std::sin(phi), 0, -std::cos(phi)};
    const Vector3 pv{-std::cos(theta) * std::cos(phi), -std::sin(theta), -std::cos(theta) * std::sin(phi)};
    const Vector3 bumped = n * 2.0 - bu * pu - bv * pv;
    return bumped * 0.5;
}

}  // namespace raytracer
