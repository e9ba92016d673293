#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {
// Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 2017
void basis(const Vector3& n, Vector3& b1, Vector3& b2) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    const double b = n.x * n.y * a;
    b1 = {1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    b2 = {b, sign + n.y * n.y * a, -n.y};
}
}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    Vector3 Pu, Pv;
    basis(n, Pu, Pv);
    if (Pv.y > 0) Pv = -Pv;   // downwards
    if (Pu.cross(Pv).dot(n) < 0) Pu = -Pu;
    const HeightMap& map = heightMap();
    const double u = std::atan2(n.x, -n.z) / (2 * std::numbers::pi) + 0.5;
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const int c = std::min(int(u * map.width()), map.width() - 1);
    const int r = std::min(int(v * map.height()), map.height() - 1);
    const double Bu = map.at((c + 1) % map.width(), r) - map.at(c, r);
    const double Bv = r + 1 < map.height() ? map.at(c, r + 1) - map.at(c, r) : 0.0;
    return (n - Bu * Pu - Bv * Pv).normalised();
}

}  // namespace raytracer
