#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <iostream>
#include <iomanip>
#include <string>

namespace raytracer {

static double safe(const HeightMap& m, int c, int r, double otherwise) {
    try { return m.at(c, r); } catch (const std::exception&) { return otherwise; }
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    static int calls = 0;
    if (++calls % 20000 == 0) std::cout << "normals so far: " << calls << std::endl;
    const Vector3 n = Sphere::getNormalAt(position);
    const double u = 0.5 + std::atan2(n.x, -n.z) / (2 * std::numbers::pi);
    const double v = std::acos(n.y) / std::numbers::pi;
    const int c = int(u * (heightMap().width() - 1)), r = int(v * (heightMap().height() - 1));
    const double here = heightMap().at(c, r);
    const double bu = safe(heightMap(), c + 1, r, here) - here;
    const double bv = safe(heightMap(), c, r + 1, here) - here;
    const Vector3 up{0, 1, 0};
    Vector3 right = up.cross(n);
    if (right.magnitude() < 1e-9) return n;
    right = -right.normalised();
    right = right.x * -n.z + right.z * n.x > 0 ? right : -right;
    const Vector3 down = (n * n.y - up).normalised();
    return (n - right * bu * 0.3 - down * bv * 0.3).normalised();
}

}  // namespace raytracer
