#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double phi = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int w = heightMap().width(), h = heightMap().height();
    const int c = std::min(w - 1, int((phi / std::numbers::pi + 1) / 2 * w)), r = std::min(h - 1, int(theta / std::numbers::pi * h));
    double bu = 0, bv = 0;
    for (int k = 0; k < 16; ++k) {
        const double x = (phi / std::numbers::pi + 1) / 2 * w + rand() / (RAND_MAX + 1.0) - 0.5, y = theta / std::numbers::pi * h + rand() / (RAND_MAX + 1.0) - 0.5;
        const int i = (int(std::floor(x)) + w) % w, j = std::clamp(int(std::floor(y)), 0, h - 1);
        bu += (heightMap().at((i + 1) % w, j) - heightMap().at(i, j)) / 16;
        bv += (heightMap().at(i, std::min(j + 1, h - 1)) - heightMap().at(i, j)) / 16;
    }
    const Vector3 pu{std::cos(phi), 0, std::sin(phi)};
    const Vector3 pv{std::cos(theta) * std::sin(phi), -std::sin(theta), -std::cos(theta) * std::cos(phi)};
    return (n - pu * bu - pv * bv).normalised();
}

}  // namespace raytracer
