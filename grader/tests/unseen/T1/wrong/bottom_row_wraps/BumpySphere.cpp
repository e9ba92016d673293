#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace np {
// like numpy.roll / a[i % n]: negative and too large indices come round
static int wrap(int i, int n) { return (i % n + n) % n; }
}  // namespace np

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double phi = std::atan2(n.x, -n.z);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int shape[] = {heightMap().height(), heightMap().width()};
    const auto b = [&](int row, int col) {
        return heightMap().at(np::wrap(col, shape[1]), np::wrap(row, shape[0]));
    };
    const int col = static_cast<int>(std::floor((phi / (2 * std::numbers::pi) + 0.5) * shape[1]));
    const int row = std::min(static_cast<int>(std::floor(theta / std::numbers::pi * shape[0])), shape[0] - 1);
    const double bu = b(row, col + 1) - b(row, col);
    const double bv = b(row + 1, col) - b(row, col);
    const Vector3 pu{std::cos(phi), 0, std::sin(phi)};
    const Vector3 pv{std::sin(phi) * std::cos(theta), -std::sin(theta), -std::cos(phi) * std::cos(theta)};
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
