#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

// A slope as steepness and bearing: 0 east, a quarter turn north.
struct Compass {
    double steepness;
    double bearing;
};

Compass survey(const HeightMap& map, double u, double v) {
    const int x = std::min(map.width() - 2, static_cast<int>(u * map.width()));
    const int y = std::min(map.height() - 2, static_cast<int>(v * map.height()));
    const double dx = map.at(x + 1, y) - map.at(x, y);
    const double dy = map.at(x, y + 1) - map.at(x, y);
    return {std::hypot(dx, dy), std::atan2(dy, dx)};
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double u = 0.5 + std::atan2(n.x, -n.z) / (2 * std::numbers::pi);
    const double v = 0.5 - std::asin(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const Compass slope = survey(heightMap(), u, v);

    const Vector3 pole{0.0, 1.0, 0.0};
    Vector3 east = n.cross(pole);
    if (east.magnitude() < 1e-9) return n;
    east = east.normalised();
    const Vector3 north = (pole - n * n.dot(pole)).normalised();
    const Vector3 uphill = std::cos(slope.bearing) * east + std::sin(slope.bearing) * north;
    const double lean = std::atan(slope.steepness);
    return std::cos(lean) * n - std::sin(lean) * uphill;
}

}  // namespace raytracer
