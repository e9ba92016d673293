// No parametrisation of the tangents at all: builds the displaced surface
//     S(d) = d * exp(k * B(d))        d: unit direction, B: bilinear height
// in the neighbourhood of the point, takes two chords of it, and their cross product.
// The exponential keeps the steepness independent of the height itself.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

class DisplacedBall {
public:
    explicit DisplacedBall(const HeightMap& map)
        : map_(map), k_(2.0 * std::numbers::pi / map.width()) {}

    Vector3 operator()(const Vector3& direction) const {
        const Vector3 d = direction.normalised();
        return d * std::exp(k_ * height(d));
    }

private:
    double height(const Vector3& d) const {
        const double u = 0.5 + std::atan2(d.x, -d.z) / (2.0 * std::numbers::pi);
        const double v = std::acos(std::clamp(d.y, -1.0, 1.0)) / std::numbers::pi;
        const double x = u * map_.width() - 0.5, y = v * map_.height() - 0.5;
        const double fx = std::floor(x), fy = std::floor(y);
        const double s = x - fx, t = y - fy;
        const int i = static_cast<int>(fx), j = static_cast<int>(fy);
        const double upper = (1.0 - s) * texel(i, j) + s * texel(i + 1, j);
        const double lower = (1.0 - s) * texel(i, j + 1) + s * texel(i + 1, j + 1);
        return (1.0 - t) * upper + t * lower;
    }

    double texel(int i, int j) const {
        const int w = map_.width();
        return map_.at(((i % w) + w) % w, std::clamp(j, 0, map_.height() - 1));
    }

    const HeightMap& map_;
    double k_;
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    // any two directions in the tangent plane
    const Vector3 helper = std::abs(n.x) < 0.7 ? Vector3{1, 0, 0} : Vector3{0, 0, 1};
    const Vector3 a = n.cross(helper).normalised();
    const Vector3 b = n.cross(a);

    const DisplacedBall surface{heightMap()};
    constexpr double eps = 1e-5;
    const Vector3 alongA = surface(n + a * eps) - surface(n - a * eps);
    const Vector3 alongB = surface(n + b * eps) - surface(n - b * eps);
    Vector3 normal = alongA.cross(alongB).normalised();
    if (normal.dot(n) < 0.0) normal = -normal;
    return normal;
    // TASK T1 end
}

}  // namespace raytracer
