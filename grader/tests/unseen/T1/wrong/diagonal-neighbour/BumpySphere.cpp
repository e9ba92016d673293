#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 normal = Sphere::getNormalAt(position);
    double lambda = std::atan2(normal.x, -normal.z);
    double theta = std::acos(std::clamp(normal.y, -1.0, 1.0));
    double u = lambda / (2 * std::numbers::pi) + 0.5;
    double v = theta / std::numbers::pi;

    Vector3 tangentU{std::cos(lambda), 0, std::sin(lambda)};
    Vector3 tangentV{std::sin(lambda) * std::cos(theta), -std::sin(theta),
                     -std::cos(lambda) * std::cos(theta)};

    int x = std::min<int>(u * heightMap().width(), heightMap().width() - 1);
    int y = std::min<int>(v * heightMap().height(), heightMap().height() - 1);
    double height = heightMap().at(x, y);

    // gradient along u
    x++;
    if (x == heightMap().width()) x = 0;
    double gradientU = heightMap().at(x, y) - height;
    // gradient along v
    y++;
    if (y == heightMap().height()) y--;
    double gradientV = heightMap().at(x, y) - height;

    return (normal - gradientU * tangentU - gradientV * tangentV).normalised();
    // TASK T1 end
}

}  // namespace raytracer
