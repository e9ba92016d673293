#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

struct Quaternion {
    double w{1.0};
    Vector3 v{};

    [[nodiscard]] static Quaternion turn(const Vector3& axis, double angle) {
        return {std::cos(angle / 2.0), axis * std::sin(angle / 2.0)};
    }
    [[nodiscard]] Quaternion operator*(const Quaternion& q) const {
        return {w * q.w - v.dot(q.v), q.v * w + v * q.w + v.cross(q.v)};
    }
    [[nodiscard]] Vector3 operator()(const Vector3& p) const {
        const Vector3 t = v.cross(p) * 2.0;
        return p + t * w + v.cross(t);
    }
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z);
    const double lat = std::asin(std::clamp(n.y, -1.0, 1.0));

    const HeightMap& map = heightMap();
    const int W = map.width(), H = map.height();
    const int i = std::clamp(static_cast<int>((0.5 + 0.5 * lon / std::numbers::pi) * W), 0, W - 1);
    const int j = std::clamp(static_cast<int>((0.5 - lat / std::numbers::pi) * H), 0, H - 1);
    const double here = map.at(i, j);
    const double slopeRight = map.at(i + 1 == W ? 0 : i + 1, j) - here;
    const double slopeDown = j + 1 < H ? map.at(i, j + 1) - here : 0.0;

    // The tilted normal at the point that is nearest to the camera, where right is +x, down -y and
    // outwards -z; then the whole sphere is turned so that this point comes to the position.
    const Vector3 inFront = Vector3{-slopeRight, slopeDown, -1.0}.normalised();
    const Quaternion raise = Quaternion::turn({1.0, 0.0, 0.0}, lat);
    const Quaternion spin = Quaternion::turn({0.0, 1.0, 0.0}, -lon);
    return (spin * raise)(inFront).normalised();
    // TASK T1 end
}

}  // namespace raytracer
