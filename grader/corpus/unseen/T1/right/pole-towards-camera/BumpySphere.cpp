// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    // The top of the map is at (0, 0, -1), the bottom at (0, 0, 1):
    //   n = (sin t cos a, sin t sin a, -cos t)
    const Vector3 n = Sphere::getNormalAt(position);
    const double t = std::acos(std::clamp(-n.z, -1.0, 1.0));
    const double a = std::atan2(n.y, n.x);
    const Vector3 dnda{-std::sin(a), std::cos(a), 0.0};
    const Vector3 dndt{std::cos(t) * std::cos(a), std::cos(t) * std::sin(a), std::sin(t)};
    // At a = 0, t = 90 degrees: dnda = y, dndt = z, and y x z = x = n. So it is Equation (2).

    const auto& map = heightMap();
    const int W = map.width(), H = map.height();
    int column = static_cast<int>(std::floor(a / (2 * std::numbers::pi) * W));
    if (column < 0) column += W;
    if (column >= W) column -= W;
    const int row = std::min(static_cast<int>(t / std::numbers::pi * H), H - 1);
    const int nextColumn = column == W - 1 ? 0 : column + 1;
    const int nextRow = row == H - 1 ? row : row + 1;

    const double Bu = map.at(nextColumn, row) - map.at(column, row);
    const double Bv = map.at(column, nextRow) - map.at(column, row);
    return (n + Bu * n.cross(dndt) - Bv * n.cross(dnda)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
