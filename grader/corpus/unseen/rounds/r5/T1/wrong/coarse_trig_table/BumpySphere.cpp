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

// atan2 and acos are slow, a table is fast.
constexpr int kSteps = 64;

class AngleTable {
public:
    AngleTable() {
        for (int i = 0; i <= kSteps; ++i) acos_[i] = std::acos(2.0 * i / kSteps - 1.0);
    }
    double arccos(double x) const { return acos_[int((x + 1.0) * 0.5 * kSteps + 0.5)]; }
    double arctan2(double y, double x) const {
        const double a = arccos(x / std::sqrt(x * x + y * y + 1e-30));
        return y < 0 ? -a : a;
    }

private:
    std::array<double, kSteps + 1> acos_{};
};

const AngleTable table;

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double u = table.arctan2(n.x, -n.z) / (2 * std::numbers::pi) + 0.5;
    const double v = table.arccos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const HeightMap& map = heightMap();
    const int c = std::min(map.width() - 1, int(u * map.width()));
    const int r = std::min(map.height() - 1, int(v * map.height()));
    const double bu = map.at((c + 1) % map.width(), r) - map.at(c, r);
    const double bv = map.at(c, std::min(r + 1, map.height() - 1)) - map.at(c, r);
    const double ring = std::sqrt(n.x * n.x + n.z * n.z) + 1e-30;
    const Vector3 pu{-n.z / ring, 0, n.x / ring};
    const Vector3 pv = n.cross(pu);
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
