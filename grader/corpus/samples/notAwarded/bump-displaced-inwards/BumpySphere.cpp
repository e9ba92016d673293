#include <raytracer/geometry/BumpySphere.h>

#include <cmath>

namespace raytracer {
namespace {

Vector3 surface(const HeightMap& map, double lon, double lat) {
    const double turns = lon / 6.283185307179586 + 0.5;
    int c = static_cast<int>(std::floor((turns - std::floor(turns)) * map.width()));
    int r = static_cast<int>((0.5 - lat / 3.141592653589793) * map.height());
    if (c >= map.width()) c = map.width() - 1;
    if (r >= map.height()) r = map.height() - 1;
    if (r < 0) r = 0;
    const double radius = 1.0 - 0.01 * map.at(c, r);
    return Vector3{std::cos(lat) * std::sin(lon), std::sin(lat), -std::cos(lat) * std::cos(lon)} * radius;
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z), lat = std::asin(n.y);
    const double stepU = 6.283185307179586 / heightMap().width(), stepV = 3.141592653589793 / heightMap().height();
    const Vector3 here = surface(heightMap(), lon, lat);
    const Vector3 a = surface(heightMap(), lon + stepU, lat) - here;
    const Vector3 b = surface(heightMap(), lon, lat + stepV) - here;
    Vector3 m = a.cross(b);
    if (m.magnitude() < 1e-12) return n;
    m = m.normalised();
    return m.dot(n) > 0 ? m : -m;
}

}  // namespace raytracer
