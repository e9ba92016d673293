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

// Port of my Java class: int[][] heights
class IntGrid {
public:
    explicit IntGrid(const HeightMap& m) : m_(m) {}
    int operator()(int c, int r) const {
        const int w = m_.width();
        return static_cast<int>(m_.at(((c % w) + w) % w, std::clamp(r, 0, m_.height() - 1)));
    }

private:
    const HeightMap& m_;
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 N = Sphere::getNormalAt(position);
    const double phi = std::atan2(N.x, -N.z);
    const double theta = std::acos(std::clamp(N.y, -1.0, 1.0));
    const IntGrid B{heightMap()};
    const int c = static_cast<int>((phi / (2.0 * std::numbers::pi) + 0.5) * heightMap().width());
    const int r = static_cast<int>(theta / std::numbers::pi * heightMap().height());
    const double Bu = B(c + 1, r) - B(c, r);
    const double Bv = B(c, r + 1) - B(c, r);
    const Vector3 Pu{std::cos(phi), 0.0, std::sin(phi)};
    const Vector3 Pv{std::sin(phi) * std::cos(theta), -std::sin(theta), -std::cos(phi) * std::cos(theta)};
    return (N + N.cross(Pv) * Bu - N.cross(Pu) * Bv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
