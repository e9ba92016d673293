// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const int W = heightMap().width();
    const int H = heightMap().height();
    const double pi = std::numbers::pi;

    // Columns: seen from above, is the point east of the meridian at the left edge of column k?
    // Meridian k / W has the direction (-sin, cos) in (x, z), since u = 0 is at the back.
    const double x = n.x, z = n.z;
    int lo = 0, hi = W;  // invariant: edge lo is not east of the point
    const bool rightHalf = x > 0 || (x == 0 && z < 0);
    while (hi - lo > 1) {
        const int mid = (lo + hi) / 2;
        const bool midRight = 2 * mid >= W;
        bool eastOf;
        if (rightHalf != midRight) {
            eastOf = rightHalf;
        } else {
            const double a = 2 * pi * mid / W;
            const double mx = -std::sin(a), mz = std::cos(a);
            // eastward tangent of that meridian
            eastOf = x * -mz + z * mx >= 0;
        }
        (eastOf ? lo : hi) = mid;
    }
    const int col = lo;

    // Rows: parallels have heights cos(pi k / H), falling.
    lo = 0;
    hi = H;
    while (hi - lo > 1) {
        const int mid = (lo + hi) / 2;
        (n.y <= std::cos(pi * mid / H) ? lo : hi) = mid;
    }
    const int row = lo;

    const double rho = std::hypot(x, z);
    const Vector3 east = rho > 1e-12 ? Vector3{-z / rho, 0, x / rho} : Vector3{1, 0, 0};
    const Vector3 south = n.cross(east);
    const double du = heightMap().at((col + 1) % W, row) - heightMap().at(col, row);
    const double dv = heightMap().at(col, std::min(row + 1, H - 1)) - heightMap().at(col, row);
    return (n - east * du - south * dv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
