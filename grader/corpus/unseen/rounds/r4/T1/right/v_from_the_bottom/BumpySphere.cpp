// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    // v goes UP here: v = 0 at the south pole
    Vector3 n = Sphere::getNormalAt(position);
    double a = std::atan2(n.x, -n.z);
    double b = std::numbers::pi - std::acos(std::max(-1.0, std::min(1.0, n.y)));   // from the bottom
    double u = (a + std::numbers::pi) / (2 * std::numbers::pi);
    double v = b / std::numbers::pi;

    Vector3 Pu{std::cos(a), 0, std::sin(a)};
    // d/db of (sin a sin b, -cos b, -cos a sin b)
    Vector3 Pv{std::sin(a) * std::cos(b), std::sin(b), -std::cos(a) * std::cos(b)};

    const HeightMap& m = heightMap();
    int col = static_cast<int>(u * m.width()) % m.width();
    int fromBottom = static_cast<int>(v * m.height());
    if (fromBottom == m.height()) fromBottom--;
    int row = m.height() - 1 - fromBottom;   // row 0 is at the top

    double Bu = m.at((col + 1) % m.width(), row) - m.at(col, row);
    double Bv = 0;
    if (row > 0) Bv = m.at(col, row - 1) - m.at(col, row);   // one texel further UP

    // Pu right, Pv up: Pu x Pv = -n, so equation (3)
    Vector3 bumped = n - Bu * n.cross(Pv) + Bv * n.cross(Pu);
    return bumped.normalised();
    // TASK T1 end
}

}  // namespace raytracer
