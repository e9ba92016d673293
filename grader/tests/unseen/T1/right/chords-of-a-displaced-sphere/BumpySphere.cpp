#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <numbers>

// Blinn's way the long way round: really displace the surface a little, take two chords of it and
// cross them.
namespace raytracer {
namespace {
double mix(double a, double b, double t) {
    return a + (b - a) * t;
}

double bilinear(const HeightMap& map, double u, double v) {
    const double x = (u - std::floor(u)) * map.width() - 0.5;
    const double y = std::clamp(v * map.height() - 0.5, 0.0, map.height() - 1.0);
    const int x0 = static_cast<int>(std::floor(x));
    const int y0 = std::min(static_cast<int>(y), map.height() - 2);
    const auto col = [&](int c) { return (c % map.width() + map.width()) % map.width(); };
    return mix(mix(map.at(col(x0), y0), map.at(col(x0 + 1), y0), x - x0),
               mix(map.at(col(x0), y0 + 1), map.at(col(x0 + 1), y0 + 1), x - x0), y - y0);
}

Vector3 displaced(const HeightMap& map, double u, double v) {
    const double lambda = (u - 0.5) * 2.0 * std::numbers::pi;
    const double theta = v * std::numbers::pi;
    const double r = 1.0 + 0.02 * bilinear(map, u, v);
    return Vector3{std::sin(lambda) * std::sin(theta), std::cos(theta),
                   -std::cos(lambda) * std::sin(theta)} *
           r;
}
}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double u = std::atan2(n.x, -n.z) / (2.0 * std::numbers::pi) + 0.5;
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const double du = 0.5 / heightMap().width();
    const double dv = 0.5 / heightMap().height();
    const double vSafe = std::clamp(v, dv, 1.0 - dv);
    const Vector3 along =
        displaced(heightMap(), u + du, vSafe) - displaced(heightMap(), u - du, vSafe);
    const Vector3 down =
        displaced(heightMap(), u, vSafe + dv) - displaced(heightMap(), u, vSafe - dv);
    Vector3 bumped = along.cross(down).normalised();
    if (bumped.dot(n) < 0.0) bumped = -bumped;
    return bumped;
}
}  // namespace raytracer
