#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

// Saves a look-up: the neighbour is the point that was shaded just before this one.
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    thread_local double heightBefore = 0.0;
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z);
    const double col = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int w = heightMap().width();
    const int h = heightMap().height();
    const int x = static_cast<int>((lon / (2 * std::numbers::pi) + 0.5) * w) % w;
    const int y = std::min(static_cast<int>(col / std::numbers::pi * h), h - 1);
    const double here = heightMap().at(x, y);
    const double bu = here - heightBefore;
    const double bv = heightMap().at(x, std::min(y + 1, h - 1)) - here;
    heightBefore = here;
    const Vector3 pu{std::cos(lon), 0, std::sin(lon)};
    const Vector3 pv = pu.cross(n);
    const double down = pv.y > 0.0 ? -1.0 : 1.0;
    return (n - pu * bu - pv * (down * bv)).normalised();
}

}  // namespace raytracer
