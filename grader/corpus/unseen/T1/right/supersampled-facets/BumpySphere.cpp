#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace raytracer {
namespace {

struct Clay {
    const BumpySphere& sphere;

    double relief(double u, double v) const {
        const HeightMap& map = sphere.heightMap();
        const double x = (u - std::floor(u)) * map.width() - 0.5;
        const double y = std::clamp(v * map.height() - 0.5, 0.0, map.height() - 1.0);
        const int i = static_cast<int>(std::floor(x));
        const int j = std::min(static_cast<int>(y), map.height() - 2);
        const auto wrap = [&](int c) { return (c + map.width()) % map.width(); };
        const double fx = x - i;
        const double fy = y - j;
        return (1 - fy) * ((1 - fx) * map.at(wrap(i), j) + fx * map.at(wrap(i + 1), j)) +
               fy * ((1 - fx) * map.at(wrap(i), j + 1) + fx * map.at(wrap(i + 1), j + 1));
    }

    // A point of the lumpy surface, in units of the radius.
    Vector3 point(double u, double v) const {
        const double a = 2.0 * std::numbers::pi * u;
        const double b = std::numbers::pi * v;
        const double size = 1.0 + 0.03 * relief(u, v);
        return Vector3{-std::sin(a) * std::sin(b), std::cos(b), std::cos(a) * std::sin(b)} * size;
    }
};

}  // namespace

// The sum of the facets around the point: four triangles with corners a third of a percent away.
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double u = std::atan2(-n.x, n.z) / (2.0 * std::numbers::pi);
    const double v = std::atan2(std::sqrt(n.x * n.x + n.z * n.z), n.y) / std::numbers::pi;
    const Clay clay{*this};
    const double reach = 1.0 / 300.0;
    const Vector3 middle = clay.point(u, v);
    const std::vector<Vector3> ring{clay.point(u + reach, v), clay.point(u, v + reach),
                                    clay.point(u - reach, v), clay.point(u, v - reach)};
    Vector3 sum{0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < 4; ++i)
        sum = sum + (ring[i] - middle).cross(ring[(i + 1) % 4] - middle);
    const Vector3 facet = sum.normalised();
    return facet.dot(n) < 0.0 ? -facet : facet;
}

}  // namespace raytracer
