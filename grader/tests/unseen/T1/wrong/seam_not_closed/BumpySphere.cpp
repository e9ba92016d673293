#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

// A texture unit in clamp mode.
struct Texture {
    const HeightMap& map;
    double fetch(int c, int r) const {
        return map.at(std::clamp(c, 0, map.width() - 1), std::clamp(r, 0, map.height() - 1));
    }
    double ddx(int c, int r) const { return fetch(c + 1, r) - fetch(c, r); }
    double ddy(int c, int r) const { return fetch(c, r + 1) - fetch(c, r); }
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    double lon = std::atan2(n.x, -n.z);
    if (lon < 0.0) lon += 2.0 * std::numbers::pi;
    const double lat = std::acos(std::clamp(n.y, -1.0, 1.0));

    const Texture texture{heightMap()};
    const int c = std::min(static_cast<int>(lon / (2.0 * std::numbers::pi) * heightMap().width()), heightMap().width() - 1);
    const int r = std::min(static_cast<int>(lat / std::numbers::pi * heightMap().height()), heightMap().height() - 1);

    const Vector3 right{std::cos(lon), 0.0, std::sin(lon)};
    const Vector3 down{std::sin(lon) * n.y, -std::sin(lat), -std::cos(lon) * n.y};
    return (n - texture.ddx(c, r) * right - texture.ddy(c, r) * down).normalised();
    // TASK T1 end
}

}  // namespace raytracer
