#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    double lambda = std::atan2(n.x, -n.z);
    double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const HeightMap& map = heightMap();
    const int W = map.width(), H = map.height();
    const int i = std::min(int((lambda / std::numbers::pi + 1) * 0.5 * W), W - 1);
    const int j = std::min(int(theta / std::numbers::pi * H), H - 1);
    // what rises to the right faces to the left: turn the normal by the slope
    lambda -= map.at((i + 1) % W, j) - map.at(i, j);
    if (j + 1 < H) theta -= map.at(i, j + 1) - map.at(i, j);
    return Vector3{std::sin(lambda) * std::sin(theta), std::cos(theta), -std::cos(lambda) * std::sin(theta)}
        .normalised();
}

}  // namespace raytracer
