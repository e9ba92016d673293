#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double phi = std::atan2(n.x, -n.z);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const HeightMap& m = heightMap();
    const int c = std::min(int((phi / std::numbers::pi + 1) / 2 * m.width()), m.width() - 1);
    const int r = std::min(int(theta / std::numbers::pi * m.height()), m.height() - 1);

    // how steep is it here? (size of the step to the neighbour)
    const double steepU = std::abs(m.at((c + 1) % m.width(), r) - m.at(c, r));
    const double steepV = std::abs(m.at(c, std::min(r + 1, m.height() - 1)) - m.at(c, r));

    const Vector3 pu{std::cos(phi), 0.0, std::sin(phi)};
    const Vector3 pv = n.cross(pu);
    return (n - steepU * pu - steepV * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
