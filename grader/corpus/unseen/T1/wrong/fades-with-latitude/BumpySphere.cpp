#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

struct Place {
    int column = 0;
    int row = 0;
};

struct Look {
    const HeightMap& map;

    Place at(const Vector3& n) const {
        const double u = 0.5 + 0.5 * std::atan2(n.x, -n.z) / std::numbers::pi;
        const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
        return {std::min(static_cast<int>(u * map.width()), map.width() - 1),
                std::min(static_cast<int>(v * map.height()), map.height() - 1)};
    }
    double height(Place p) const {
        return map.at(p.column % map.width(), std::min(p.row, map.height() - 1));
    }
    double right(Place p) const { return height({p.column + 1, p.row}) - height(p); }
    double below(Place p) const { return height({p.column, p.row + 1}) - height(p); }
};

struct Frame {
    Vector3 right;
    Vector3 down;

    explicit Frame(const Vector3& n) {
        const double ring = std::max(1e-12, std::hypot(n.x, n.z));
        right = {-n.z / ring, 0.0, n.x / ring};
        down = {n.x * n.y / ring, -ring, n.z * n.y / ring};
    }
};

}  // namespace

// Strongest in the middle of the upper half, nothing on the equator, where lights glare.
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const Look look{heightMap()};
    const Frame frame{n};
    const Place p = look.at(n);
    const double fade = 2.0 * std::hypot(n.x, n.z) * n.y;
    return (n - (frame.right * look.right(p) + frame.down * look.below(p)) * fade).normalised();
}

}  // namespace raytracer
