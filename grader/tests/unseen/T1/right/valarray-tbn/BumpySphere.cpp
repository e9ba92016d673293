#include <raytracer/geometry/BumpySphere.h>
#include <cmath>
#include <valarray>

namespace raytracer {
using Vec = std::valarray<double>;

static Vec unit(const Vec& v) {
    return v / std::sqrt((v * v).sum());
}

static Vec crossed(const Vec& a, const Vec& b) {
    return Vec(a.cshift(1) * b.cshift(2)) - Vec(a.cshift(2) * b.cshift(1));
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vec c{centre().x, centre().y, centre().z};
    const Vec p{position.x, position.y, position.z};
    const Vec n = unit(p - c);

    // Tangent, bitangent, normal: the columns of a matrix that takes "map space" to world space.
    Vec t{-n[2], 0.0, n[0]};
    if ((t * t).sum() < 1e-18) t = Vec{1.0, 0.0, 0.0};
    t = unit(t);
    const Vec b = crossed(n, t);  // along the meridian, towards the bottom
    const double phi = std::atan2(n[2], n[0]);
    const double theta = std::acos(n[1] > 1 ? 1 : n[1] < -1 ? -1 : n[1]);

    const auto& map = heightMap();
    const double pi = 4 * std::atan(1.0);
    // u = 0 at +x, growing towards +z ... which is to the left seen from outside on the near side,
    // so the other way round:
    double u = std::fmod(phi / (2 * pi) + 1.0, 1.0);
    const int col = static_cast<int>(u * map.width()) % map.width();
    const int row = std::min(static_cast<int>(theta / pi * map.height()), map.height() - 1);
    const double du = map.at((col + 1) % map.width(), row) - map.at(col, row);
    const double dv = map.at(col, std::min(row + 1, map.height() - 1)) - map.at(col, row);
    const Vec local{-du, -dv, 1.0};
    const Vec world = unit(t * local[0] + b * local[1] + n * local[2]);
    return {world[0], world[1], world[2]};
}
}  // namespace raytracer
