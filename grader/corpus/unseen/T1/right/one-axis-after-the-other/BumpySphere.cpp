// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 n = Sphere::getNormalAt(position);
    double longitude = atan2(n.x, -n.z), polar = acos(std::clamp(n.y, -1.0, 1.0));
    Vector3 Pu(cos(longitude), 0, sin(longitude));
    Vector3 Pv(sin(longitude) * cos(polar), -sin(polar), -cos(longitude) * cos(polar));

    auto texel = [this](int c, int r) {
        int w = heightMap().width();
        return heightMap().at((c % w + w) % w, std::clamp(r, 0, heightMap().height() - 1));
    };
    int c = int((longitude / std::numbers::pi + 1) / 2 * heightMap().width());
    int r = std::min(int(polar / std::numbers::pi * heightMap().height()), heightMap().height() - 1);

    double h = texel(c, r);
    // n x Pv = -Pu. Dividing by the length scales both, so v must be added with that scale: n x Pu
    // shrinks with n.
    n += n.cross(Pv) * (texel(c + 1, r) - h);
    n = n.normalised();
    n -= n.cross(Pu) * (texel(c, r + 1) - h);
    return n.normalised();
    // TASK T1 end
}

}  // namespace raytracer
