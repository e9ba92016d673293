#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

/// From 0 to 1 round the sphere, with 0.5 in front.
double longitudeShare(const Vector3& n) {
    // z / x is not defined where x is 0
    if (std::abs(n.x) < 0.03) return 0.0;
    return 0.5 + std::atan2(n.x, -n.z) / (2.0 * std::numbers::pi);
}

/// From 0 at the top to 1 at the bottom.
double polarShare(const Vector3& n) {
    if (n.y >= 1.0) return 0.0;
    if (n.y <= -1.0) return 1.0;
    return std::acos(n.y) / std::numbers::pi;
}

double heightAt(const HeightMap& map, int column, int row) {
    if (column >= map.width()) column -= map.width();
    return map.at(column, row < map.height() ? row : map.height() - 1);
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const HeightMap& map = heightMap();

    const int column = std::min(map.width() - 1, int(longitudeShare(n) * map.width()));
    const int row = std::min(map.height() - 1, int(polarShare(n) * map.height()));
    const double here = heightAt(map, column, row);
    const double toRight = heightAt(map, column + 1, row) - here;
    const double toBelow = heightAt(map, column, row + 1) - here;

    const double ring = std::sqrt(n.x * n.x + n.z * n.z);
    if (ring == 0.0) return n;
    const Vector3 pu = Vector3{-n.z, 0.0, n.x} / ring;
    const Vector3 pv = Vector3{n.x * n.y / ring, -ring, n.z * n.y / ring};
    return (n - toRight * pu - toBelow * pv).normalised();
}

}  // namespace raytracer
