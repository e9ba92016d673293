#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position).normalised();
    const double u = std::atan2(n.x, -n.z) / (2.0 * std::numbers::pi) + 0.5;
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const double a = (u - 0.5) * 2.0 * std::numbers::pi;
    const double b = v * std::numbers::pi;
    // both of these have length one, n as well
    const Vector3 pu = Vector3(std::cos(a), 0.0, std::sin(a)).normalised();
    const Vector3 pv =
        Vector3(std::sin(a) * std::cos(b), -std::sin(b), -std::cos(a) * std::cos(b)).normalised();

    const int w = heightMap().width();
    const int h = heightMap().height();
    const int i = std::min(static_cast<int>(u * w), w - 1);
    const int j = std::min(static_cast<int>(v * h), h - 1);
    const double bu = heightMap().at((i + 1) % w, j) - heightMap().at(i, j);
    const double bv = heightMap().at(i, std::min(j + 1, h - 1)) - heightMap().at(i, j);
    return n - bu * pu - bv * pv;
    // TASK T1 end
}

}  // namespace raytracer
