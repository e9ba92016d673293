#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    Vector3 n = (position - centre()) / radius();
    double u = 0.5 + std::atan2(n.x, -n.z) / (2.0 * std::numbers::pi);
    double v = 0.5 - std::asin(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    int c = std::clamp(int(u * heightMap().width()), 0, heightMap().width() - 1);
    int r = std::clamp(int(v * heightMap().height()), 0, heightMap().height() - 1);
    double dx = heightMap().at(std::min(c + 1, heightMap().width() - 1), r) - heightMap().at(c, r);
    double dy = heightMap().at(c, std::min(r + 1, heightMap().height() - 1)) - heightMap().at(c, r);
    n.x -= dx;
    n.y += dy;
    return n.normalised();
}

}  // namespace raytracer
