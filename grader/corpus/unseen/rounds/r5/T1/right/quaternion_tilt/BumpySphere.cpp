#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

class Quaternion {
public:
    Quaternion(double w, const Vector3& v) : w_(w), v_(v) {}
    static Quaternion aboutAxis(const Vector3& unitAxis, double angle) {
        return {std::cos(angle / 2), unitAxis * std::sin(angle / 2)};
    }
    [[nodiscard]] Quaternion conjugate() const { return {w_, -v_}; }
    [[nodiscard]] Vector3 rotate(const Vector3& p) const {
        return ((*this * Quaternion{0.0, p}) * conjugate()).v_;
    }
    friend Quaternion operator*(const Quaternion& a, const Quaternion& b) {
        return {a.w_ * b.w_ - a.v_.dot(b.v_), a.w_ * b.v_ + b.w_ * a.v_ + a.v_.cross(b.v_)};
    }

private:
    double w_;
    Vector3 v_;
};

struct Spherical {
    double lon;
    double pol;
    explicit Spherical(const Vector3& n)
        : lon(std::atan2(n.x, -n.z)), pol(std::acos(std::clamp(n.y, -1.0, 1.0))) {}
    [[nodiscard]] Vector3 east() const { return {std::cos(lon), 0, std::sin(lon)}; }
    [[nodiscard]] Vector3 south() const {
        return {std::sin(lon) * std::cos(pol), -std::sin(pol), -std::cos(lon) * std::cos(pol)};
    }
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const Spherical s{n};
    const HeightMap& m = heightMap();
    const int w = m.width();
    const int h = m.height();
    const int i = std::min(w - 1, static_cast<int>(w * (s.lon / (2 * std::numbers::pi) + 0.5)));
    const int j = std::min(h - 1, static_cast<int>(h * (s.pol / std::numbers::pi)));
    const double rise = m.at((i + 1) % w, j) - m.at(i, j);
    const double drop = m.at(i, std::min(j + 1, h - 1)) - m.at(i, j);

    // Downhill in the tangent plane, and how steep: n is turned that way by atan(steepness).
    const Vector3 downhill = -(s.east() * rise + s.south() * drop);
    const double steepness = downhill.magnitude();
    if (steepness == 0.0) return n;
    const Vector3 axis = n.cross(downhill / steepness).normalised();
    return Quaternion::aboutAxis(axis, std::atan(steepness)).rotate(n).normalised();
    // TASK T1 end
}

}  // namespace raytracer
