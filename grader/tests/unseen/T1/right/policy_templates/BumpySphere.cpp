#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>

namespace raytracer {
namespace {

// --- addressing policies -------------------------------------------------------------------------
template <typename P>
concept AddressPolicy = requires(int i, int n) {
    { P::map(i, n) } -> std::same_as<int>;
};

struct Repeat {
    static constexpr int map(int i, int n) { return i < 0 ? i + n : (i < n ? i : i - n); }
};
struct ClampToEdge {
    static constexpr int map(int i, int n) { return i < 0 ? 0 : (i < n ? i : n - 1); }
};

// --- filter policies -----------------------------------------------------------------------------
struct Nearest {
    template <typename Fetch>
    static double sample(double x, double y, Fetch&& fetch) {
        return fetch(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
    }
};
struct Bilinear {
    template <typename Fetch>
    static double sample(double x, double y, Fetch&& fetch) {
        const double sx = x - 0.5, sy = y - 0.5;
        const int ix = static_cast<int>(std::floor(sx)), iy = static_cast<int>(std::floor(sy));
        const double ax = sx - ix, ay = sy - iy;
        return (1 - ay) * ((1 - ax) * fetch(ix, iy) + ax * fetch(ix + 1, iy)) +
               ay * ((1 - ax) * fetch(ix, iy + 1) + ax * fetch(ix + 1, iy + 1));
    }
};

template <AddressPolicy U, AddressPolicy V, typename Filter>
class Sampler {
public:
    explicit Sampler(const HeightMap& map) : map_(map) {}

    /// x and y in texels.
    [[nodiscard]] double operator()(double x, double y) const {
        return Filter::sample(x, y, [this](int i, int j) {
            return map_.at(U::map(i, map_.width()), V::map(j, map_.height()));
        });
    }

private:
    const HeightMap& map_;
};

struct Gradient {
    double right, down;
};

template <typename S>
[[nodiscard]] Gradient forwardDifference(const S& s, double x, double y) {
    const double b = s(x, y);
    return {s(x + 1.0, y) - b, s(x, y + 1.0) - b};
}

using SphereSampler = Sampler<Repeat, ClampToEdge, Bilinear>;

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double phi = std::atan2(n.x, -n.z);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double x = (phi / (2 * std::numbers::pi) + 0.5) * heightMap().width();
    const double y = theta / std::numbers::pi * heightMap().height();

    const auto [right, down] = forwardDifference(SphereSampler{heightMap()}, x, y);

    const Vector3 tangent{std::cos(phi), 0.0, std::sin(phi)};
    const Vector3 bitangent = n.cross(tangent);  // down: n x Pu = Pv where Pu x Pv = n
    return (n - tangent * right - bitangent * down).normalised();
    // TASK T1 end
}

}  // namespace raytracer
