#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // step 1
    auto n = Sphere::getNormalAt(position);
    auto theta = std::asin(std::clamp(n.y, -1.0, 1.0));
    auto phi = std::atan2(n.x, -n.z);
    // step 2
    auto Pu = Vector3{std::cos(phi), 0, std::sin(phi)};
    auto Pv = Vector3{-std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)};
    // step 3
    auto last = [](int size) { return size - 1; };
    auto col = std::clamp(int((phi / std::numbers::pi + 1) / 2 * heightMap().width()), 0, last(heightMap().width()));
    auto row = std::clamp(int((0.5 - theta / std::numbers::pi) * heightMap().height()), 0, last(heightMap().height()));
    auto here = heightMap().at(col, row);
    auto Bu = here - heightMap().at(std::min(col + 1, last(heightMap().width())), row);
    auto Bv = here - heightMap().at(col, std::min(row + 1, last(heightMap().height())));
    // step 4
    return (n + Bu * n.cross(Pv) + Bv * n.cross(Pu)).normalised();
}

}  // namespace raytracer
