// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {
struct Memo { Vector3 where{1e300, 1e300, 1e300}; Vector3 normal; };
thread_local Memo memo;   // the same point is asked again for every shadow ray
Vector3 bump(const HeightMap& map, const Vector3& n) {
    const double a = std::atan2(n.x, -n.z), b = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int W = map.width(), H = map.height();
    const int c = int((a / std::numbers::pi + 1) / 2 * W) % W, r = std::min(int(b / std::numbers::pi * H), H - 1);
    const double du = map.at((c + 1) % W, r) - map.at(c, r);
    const double dv = r + 1 < H ? map.at(c, r + 1) - map.at(c, r) : 0;
    const Vector3 pu{std::cos(a), 0, std::sin(a)}, pv = n.cross(pu);
    return (n - du * pu - dv * pv).normalised();
}
}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    if (memo.where == position) return memo.normal;
    memo.where = position;
    memo.normal = bump(heightMap(), Sphere::getNormalAt(position));
    return memo.normal;
    // TASK T1 end
}

}  // namespace raytracer
