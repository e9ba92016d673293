#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>

#define PI 3.14159265358979

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 norm = Sphere::getNormalAt(position);
    double u = (std::atan2(norm.x, -norm.z) + PI) / (2 * PI);
    double v = std::acos(std::clamp(norm.y, -1.0, 1.0)) / PI;

    int width = heightMap().width();
    int height = heightMap().height();
    int pixelX = std::min((int)(u * width), width - 1);
    int pixelY = std::min((int)(v * height), height - 1);

    double current = heightMap().at(pixelX, pixelY);
    double right = heightMap().at((pixelX + 1) % width, pixelY);
    double below = heightMap().at(pixelX, pixelY + 1);
    double bu = right - current;
    double bv = below - current;

    double az = u * 2 * PI - PI;
    double inc = v * PI;
    Vector3 pu{std::cos(az), 0, std::sin(az)};
    Vector3 pv{std::sin(az) * std::cos(inc), -std::sin(inc), -std::cos(az) * std::cos(inc)};
    return (norm + bu * norm.cross(pv) - bv * norm.cross(pu)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
