#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

struct Q {
    double w, x, y, z;
    Q operator*(const Q& b) const {
        return {w * b.w - x * b.x - y * b.y - z * b.z, w * b.x + x * b.w + y * b.z - z * b.y,
                w * b.y - x * b.z + y * b.w + z * b.x, w * b.z + x * b.y - y * b.x + z * b.w};
    }
    Q operator~() const { return {w, -x, -y, -z}; }
    static Q rotation(const Vector3& a, double t) {
        const double s = std::sin(t / 2);
        return {std::cos(t / 2), a.x * s, a.y * s, a.z * s};
    }
};

Vector3 turn(const Q& q, const Vector3& v) {
    const Q r = ~q * Q{0, v.x, v.y, v.z} * q;
    return {r.x, r.y, r.z};
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z), pol = std::acos(std::clamp(n.y, -1.0, 1.0));
    const Vector3 east{std::cos(lon), 0, std::sin(lon)};
    const Vector3 south{std::sin(lon) * std::cos(pol), -std::sin(pol), -std::cos(lon) * std::cos(pol)};
    const HeightMap& m = heightMap();
    const int c = std::min(m.width() - 1, int((lon / (2 * std::numbers::pi) + 0.5) * m.width()));
    const int r = std::min(m.height() - 1, int(pol / std::numbers::pi * m.height()));
    const double bu = m.at((c + 1) % m.width(), r) - m.at(c, r);
    const double bv = m.at(c, std::min(m.height() - 1, r + 1)) - m.at(c, r);
    // rising to the east: turn about the south; rising to the south: turn about the west
    const Q q = Q::rotation(n.cross(-east), std::atan(bu)) * Q::rotation(n.cross(-south), std::atan(bv));
    return turn(q, n).normalised();
    // TASK T1 end
}

}  // namespace raytracer
