// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    static const Vector3 c = centre();
    const Vector3 n = Sphere::getNormalAt(position);
    const Vector3 d = (position - c).normalised();
    const double lon = std::atan2(d.x, -d.z);
    const double pol = std::acos(std::clamp(d.y, -1.0, 1.0));
    const int W = heightMap().width(), H = heightMap().height();
    const int C = std::clamp(int((lon / std::numbers::pi * 0.5 + 0.5) * W), 0, W - 1);
    const int R = std::clamp(int(pol / std::numbers::pi * H), 0, H - 1);
    const double here = heightMap().at(C, R);
    const double bu = heightMap().at((C + 1) % W, R) - here;
    const double bv = R + 1 < H ? heightMap().at(C, R + 1) - here : 0.0;
    const Vector3 pu{std::cos(lon), 0, std::sin(lon)};
    const Vector3 pv = n.cross(pu);
    return (n - pu * bu - pv * bv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
