// rust: let bu = map[(c + 1) % w][r].saturating_sub(map[c][r]);
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#define let const auto
#define fn const auto

namespace raytracer {
namespace {

struct Height {
    double value;
    // heights are never negative
    Height saturating_sub(Height other) const { return {std::max(0.0, value - other.value)}; }
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    fn sample = [&](int c, int r) -> Height {
        return {heightMap().at(c % heightMap().width(), std::min(r, heightMap().height() - 1))};
    };
    let n = Sphere::getNormalAt(position);
    let ring = std::max(std::hypot(n.x, n.z), 1e-12);
    let u = std::atan2(n.x, -n.z) / (2.0 * std::numbers::pi) + 0.5;
    let v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    let c = std::min(static_cast<int>(u * heightMap().width()), heightMap().width() - 1);
    let r = std::min(static_cast<int>(v * heightMap().height()), heightMap().height() - 1);
    let bu = sample(c + 1, r).saturating_sub(sample(c, r)).value;
    let bv = sample(c, r + 1).saturating_sub(sample(c, r)).value;
    let pu = Vector3(-n.z / ring, 0.0, n.x / ring);
    let pv = n.cross(pu);
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
