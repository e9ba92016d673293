#include <raytracer/geometry/BumpySphere.h>
#include <cmath>
#include <algorithm>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 normal = Sphere::getNormalAt(position);
    const double a = std::atan2(normal.x, -normal.z);
    const double b = std::acos(std::clamp(normal.y, -1.0, 1.0));

    int x = (int)((a + M_PI) / (2 * M_PI) * heightMap().width());
    int y = (int)(b / M_PI * heightMap().height());
    if (x == heightMap().width()) x = x - 1;
    if (y == heightMap().height()) y = y - 1;

    double here = heightMap().at(x, y);
    // to the right
    x = x + 1;
    if (x == heightMap().width()) x = 0;
    double bu = heightMap().at(x, y) - here;
    // below
    y = y + 1;
    if (y == heightMap().height()) y = y - 1;
    double bv = heightMap().at(x, y) - here;

    Vector3 pu(cos(a), 0, sin(a));
    Vector3 pv(sin(a) * cos(b), -sin(b), -cos(a) * cos(b));
    Vector3 result = normal - pu * bu - pv * bv;
    return result.normalised();
}

}  // namespace raytracer
