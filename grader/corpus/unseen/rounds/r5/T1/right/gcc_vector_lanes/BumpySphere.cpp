// Four lanes of double: x, y, z, unused. GCC and Clang know how.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

typedef double v4d __attribute__((vector_size(32)));

inline v4d load(const Vector3& a) { return v4d{a.x, a.y, a.z, 0.0}; }
inline double hsum(const v4d& a) { return (a[0] + a[1]) + (a[2] + a[3]); }
inline v4d unit(const v4d& a) { return a / std::sqrt(hsum(a * a)); }

struct Texel {
    int column;
    int row;
};

// The four heights that a forward difference needs, in lanes: here, right, here, below.
inline v4d stencil(const HeightMap& map, Texel t) {
    const int right = t.column + 1 < map.width() ? t.column + 1 : 0;
    const int below = t.row + 1 < map.height() ? t.row + 1 : t.row;
    return v4d{map.at(t.column, t.row), map.at(right, t.row), map.at(t.column, t.row),
               map.at(t.column, below)};
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const v4d n = unit(load(position) - load(centre()));
    const float longitude = std::atan2(static_cast<float>(n[0]), static_cast<float>(-n[2]));
    const float polar = std::acos(std::clamp(static_cast<float>(n[1]), -1.0F, 1.0F));
    const HeightMap& map = heightMap();
    const Texel texel{
        std::clamp(static_cast<int>((longitude * 0.15915494F + 0.5F) * map.width()), 0, map.width() - 1),
        std::clamp(static_cast<int>(polar * 0.31830988F * map.height()), 0, map.height() - 1)};
    const v4d h = stencil(map, texel);

    const double sl = std::sin(longitude), cl = std::cos(longitude);
    const double sp = std::sin(polar), cp = std::cos(polar);
    const v4d pu{cl, 0.0, sl, 0.0};
    const v4d pv{sl * cp, -sp, -cl * cp, 0.0};
    const v4d tilted = unit(n - pu * (h[1] - h[0]) - pv * (h[3] - h[2]));
    return {tilted[0], tilted[1], tilted[2]};
    // TASK T1 end
}

}  // namespace raytracer
