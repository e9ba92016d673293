#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

struct Frame {
    Vector3 tangent, bitangent, normal;
    explicit Frame(const Vector3& n) : normal(n) {
        const Vector3 up{0.0, 1.0, 0.0};
        const Vector3 t = up.cross(n);
        tangent = t.magnitude() > 1e-9 ? t.normalised() : Vector3{1.0, 0.0, 0.0};
        bitangent = n.cross(tangent);
    }
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Frame frame{Sphere::getNormalAt(position)};
    const Vector3& n = frame.normal;
    const double u = 0.5 + std::atan2(n.x, -n.z) / (2.0 * std::numbers::pi);
    const double v = 0.5 - std::asin(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const int x = std::clamp(static_cast<int>(u * heightMap().width()), 0, heightMap().width() - 1);
    const int y = std::clamp(static_cast<int>(v * heightMap().height()), 0, heightMap().height() - 1);
    const int xNext = (x + 1) % heightMap().width();
    const int yNext = std::min(y + 1, heightMap().height() - 1);
    const double h = heightMap().at(x, y);
    return (n - (heightMap().at(xNext, y) - h) * frame.tangent - (heightMap().at(x, yNext) - h) * frame.bitangent)
        .normalised();
    // TASK T1 end
}

}  // namespace raytracer
