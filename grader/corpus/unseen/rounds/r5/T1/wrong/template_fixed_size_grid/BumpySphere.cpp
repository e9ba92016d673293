#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace raytracer {
namespace {

// Compile-time sizes let the compiler turn / and % into shifts.
template <int W, int H>
struct Grid {
    static_assert((W & (W - 1)) == 0 && (H & (H - 1)) == 0, "powers of two");
    const HeightMap& map;
    double operator()(unsigned c, unsigned r) const {
        return map.at(static_cast<int>(c & (W - 1)) % map.width(), static_cast<int>(r & (H - 1)) % map.height());
    }
    static int column(double u) { return int(u * W); }
    static int row(double v) { return std::min(int(v * H), H - 1); }
};
using BumpGrid = Grid<512, 256>;

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z), pol = std::acos(std::clamp(n.y, -1.0, 1.0));
    const BumpGrid b{heightMap()};
    const int c = BumpGrid::column(lon / (2 * std::numbers::pi) + 0.5), r = BumpGrid::row(pol / std::numbers::pi);
    const double bu = b(c + 1, r) - b(c, r), bv = b(c, std::min(r + 1, 255)) - b(c, r);
    const Vector3 pu{std::cos(lon), 0, std::sin(lon)};
    const Vector3 pv{std::sin(lon) * std::cos(pol), -std::sin(pol), -std::cos(lon) * std::cos(pol)};
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
