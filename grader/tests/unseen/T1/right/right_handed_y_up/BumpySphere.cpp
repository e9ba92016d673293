#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

/// A vector in an ordinary right-handed world, z towards the viewer. The type keeps me from mixing
/// it up with the kit's left-handed Vector3.
class RightHanded {
public:
    RightHanded(double x, double y, double z) : v_{x, y, z} {}
    static RightHanded fromKit(const Vector3& k) { return {k.x, k.y, -k.z}; }
    [[nodiscard]] Vector3 toKit() const { return {v_.x, v_.y, -v_.z}; }

    [[nodiscard]] double x() const { return v_.x; }
    [[nodiscard]] double y() const { return v_.y; }
    [[nodiscard]] double z() const { return v_.z; }
    [[nodiscard]] RightHanded cross(const RightHanded& b) const { return RightHanded{v_.cross(b.v_)}; }
    friend RightHanded operator*(double s, const RightHanded& a) { return RightHanded{a.v_ * s}; }
    friend RightHanded operator+(const RightHanded& a, const RightHanded& b) { return RightHanded{a.v_ + b.v_}; }
    friend RightHanded operator-(const RightHanded& a, const RightHanded& b) { return RightHanded{a.v_ - b.v_}; }

private:
    explicit RightHanded(const Vector3& v) : v_(v) {}
    Vector3 v_;
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const auto n = RightHanded::fromKit(Sphere::getNormalAt(position));
    const double azimuth = std::atan2(n.x(), n.z());
    const double elevation = std::atan2(n.y(), std::hypot(n.x(), n.z()));

    const double u = 0.5 + azimuth / (2.0 * std::numbers::pi);
    const double v = 0.5 + elevation / std::numbers::pi;  // upwards

    const int w = heightMap().width();
    const int h = heightMap().height();
    const int column = std::min(static_cast<int>(u * w), w - 1);
    const int row = std::clamp(static_cast<int>((1.0 - v) * h), 0, h - 1);
    const double b = heightMap().at(column, row);
    const double bu = heightMap().at((column + 1) % w, row) - b;
    // v grows upwards, so the next texel along v is the one above; above the first there is none.
    const double bv = row > 0 ? heightMap().at(column, row - 1) - b : 0.0;

    const RightHanded pu{std::cos(azimuth), 0.0, -std::sin(azimuth)};
    const RightHanded pv{-std::sin(azimuth) * std::sin(elevation), std::cos(elevation),
                         -std::cos(azimuth) * std::sin(elevation)};

    // Right-handed, right x up = outwards: Blinn's signs as printed in his paper.
    const RightHanded tilted = n + bu * n.cross(pv) - bv * n.cross(pu);
    return tilted.toKit().normalised();
    // TASK T1 end
}

}  // namespace raytracer
