#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    Vector3 n = Sphere::getNormalAt(position);
    int x = static_cast<int>((std::atan2(n.x, -n.z) / std::numbers::pi + 1) * 0.5 * (heightMap().width() - 1));
    int y = static_cast<int>(std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi * (heightMap().height() - 1));
    Vector3 raised = position + n * heightMap().at(x, y);
    return (raised - centre()).normalised();
}

}  // namespace raytracer
