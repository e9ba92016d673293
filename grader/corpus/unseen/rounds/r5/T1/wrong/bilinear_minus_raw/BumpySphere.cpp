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

class Sampler {
public:
    explicit Sampler(const HeightMap& m) : m_(m), w_(m.width()), h_(m.height()) {}
    double texel(int c, int r) const { return m_.at(((c % w_) + w_) % w_, std::clamp(r, 0, h_ - 1)); }
    /// Smooth between texels; x and y in texels.
    double smooth(double x, double y) const {
        const int c = int(std::floor(x)), r = int(std::floor(y));
        const double a = x - c, b = y - r;
        return std::lerp(std::lerp(texel(c, r), texel(c + 1, r), a), std::lerp(texel(c, r + 1), texel(c + 1, r + 1), a), b);
    }

private:
    const HeightMap& m_;
    int w_, h_;
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z), pol = std::acos(std::clamp(n.y, -1.0, 1.0));
    const Sampler s{heightMap()};
    const double x = (lon / (2 * std::numbers::pi) + 0.5) * heightMap().width();
    const double y = pol / std::numbers::pi * heightMap().height();
    const double here = s.texel(int(x), int(y));
    const double bu = s.smooth(x + 1, y) - here;
    const double bv = s.smooth(x, y + 1) - here;
    const Vector3 pu{std::cos(lon), 0, std::sin(lon)};
    const Vector3 pv{std::sin(lon) * std::cos(pol), -std::sin(pol), -std::cos(lon) * std::cos(pol)};
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
