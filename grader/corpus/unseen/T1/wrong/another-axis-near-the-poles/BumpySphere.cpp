#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    // Any axis that is not parallel to n.
    const Vector3 helper = std::abs(n.y) < 0.9 ? Vector3{0, -1, 0} : Vector3{1, 0, 0};
    const Vector3 right = helper.cross(n).normalised();
    const Vector3 down = n.cross(right);

    const double u = 0.5 + 0.5 * std::atan2(n.x, -n.z) / std::numbers::pi;
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const HeightMap& m = heightMap();
    const int x = std::min(int(u * m.width()), m.width() - 1);
    const int y = std::min(int(v * m.height()), m.height() - 1);
    const double toRight = m.at((x + 1) % m.width(), y) - m.at(x, y);
    const double toBelow = m.at(x, std::min(y + 1, m.height() - 1)) - m.at(x, y);
    return (n - right * toRight - down * toBelow).normalised();
    // TASK T1 end
}

}  // namespace raytracer
