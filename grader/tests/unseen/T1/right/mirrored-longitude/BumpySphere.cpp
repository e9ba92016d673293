#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

// Longitude as in the lecture notes: atan2(x, z). Seen by the camera it grows to the LEFT, therefore
// Pu points to the left too and Pu x Pv = -n.

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 normal = Sphere::getNormalAt(position);

    double lambda = std::atan2(normal.x, normal.z);
    double theta = std::acos(std::min(1.0, std::max(-1.0, normal.y)));

    double u = lambda / (2.0 * std::numbers::pi);
    if (u < 0.0) u += 1.0;
    double v = theta / std::numbers::pi;

    Vector3 pU{std::cos(lambda), 0.0, -std::sin(lambda)};
    Vector3 pV{std::sin(lambda) * std::cos(theta), -std::sin(theta),
               std::cos(lambda) * std::cos(theta)};

    const int columns = heightMap().width();
    const int rows = heightMap().height();
    int x = std::clamp(static_cast<int>(u * columns), 0, columns - 1);
    int y = std::clamp(static_cast<int>(v * rows), 0, rows - 1);

    double current = heightMap().at(x, y);
    double bU = heightMap().at((x + 1) % columns, y) - current;
    double bV = 0.0;
    if (y + 1 < rows) {
        bV = heightMap().at(x, y + 1) - current;
    }

    return (normal - normal.cross(pV) * bU + normal.cross(pU) * bV).normalised();
    // TASK T1 end
}

}  // namespace raytracer
