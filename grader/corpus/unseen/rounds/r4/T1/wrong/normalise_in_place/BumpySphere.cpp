// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

static double len(const Vector3& v) {
    return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

static void makeUnit(Vector3& v) {
    v.x /= len(v);
    v.y /= len(v);
    v.z /= len(v);
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z);
    const double pol = std::acos(std::clamp(n.y, -1.0, 1.0));
    const HeightMap& map = heightMap();
    int c = (int)((lon / (2 * std::numbers::pi) + 0.5) * map.width());
    int r = (int)(pol / std::numbers::pi * map.height());
    if (c >= map.width()) c = map.width() - 1;
    if (r >= map.height()) r = map.height() - 1;
    double bu = map.at((c + 1) % map.width(), r) - map.at(c, r);
    double bv = r < map.height() - 1 ? map.at(c, r + 1) - map.at(c, r) : 0;

    n.x = n.x - bu * std::cos(lon) - bv * std::sin(lon) * std::cos(pol);
    n.y = n.y + bv * std::sin(pol);
    n.z = n.z - bu * std::sin(lon) + bv * std::cos(lon) * std::cos(pol);
    makeUnit(n);
    return n;
    // TASK T1 end
}

}  // namespace raytracer
