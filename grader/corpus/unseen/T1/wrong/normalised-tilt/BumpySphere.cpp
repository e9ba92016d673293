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
    double len = std::sqrt(n.x * n.x + n.z * n.z);
    if (len < 1e-9) return n;
    Vector3 Pu = Vector3(-n.z, 0, n.x) / len;
    Vector3 Pv = n.cross(Pu);

    auto& map = heightMap();
    int c = int((std::atan2(n.x, -n.z) / (2 * std::numbers::pi) + 0.5) * (map.width() - 1));
    int r = int(std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi * (map.height() - 1));
    double Bu = map.at((c + 1) % map.width(), r) - map.at(c, r);
    double Bv = map.at(c, (r + 1) % map.height()) - map.at(c, r);

    Vector3 tilt = Bu * Pu + Bv * Pv;
    if (tilt.magnitude() > 0) tilt = tilt.normalised();
    return (n - tilt).normalised();
    // TASK T1 end
}

}  // namespace raytracer
