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

// Fortran habit: column-major.
class Flat {
public:
    explicit Flat(const HeightMap& m) : m_(m) {}
    double operator[](int k) const { return m_.at(k % m_.width(), k / m_.width()); }

private:
    const HeightMap& m_;
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z), pol = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int W = heightMap().width(), H = heightMap().height();
    const Flat flat{heightMap()};
    const auto B = [&](int i, int j) { return flat[(i % W) * H + std::min(j, H - 1)]; };
    const int i = std::min(W - 1, int((lon / (2 * std::numbers::pi) + 0.5) * W));
    const int j = std::min(H - 1, int(pol / std::numbers::pi * H));
    const double bu = B(i + 1, j) - B(i, j);
    const double bv = B(i, j + 1) - B(i, j);
    const Vector3 pu{std::cos(lon), 0, std::sin(lon)};
    const Vector3 pv = n.cross(pu);
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
