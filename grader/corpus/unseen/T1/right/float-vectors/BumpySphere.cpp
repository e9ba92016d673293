// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

template <typename T>
struct V3 {
    T c[3];
    V3 operator-(const V3& o) const { return {{c[0] - o.c[0], c[1] - o.c[1], c[2] - o.c[2]}}; }
    V3 operator*(T s) const { return {{c[0] * s, c[1] * s, c[2] * s}}; }
    T len() const { return std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]); }
    V3 unit() const { return *this * (T(1) / len()); }
};
using V3f = V3<float>;

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 nd = Sphere::getNormalAt(position);
    const V3f n{{static_cast<float>(nd.x), static_cast<float>(nd.y), static_cast<float>(nd.z)}};
    constexpr float PI = std::numbers::pi_v<float>;

    const float phi = std::atan2(n.c[0], -n.c[2]);  // 0 in front, grows to the right
    const float theta = std::acos(std::clamp(n.c[1], -1.0f, 1.0f));
    const float s = std::sqrt(n.c[0] * n.c[0] + n.c[2] * n.c[2]);
    if (s < 1e-6f) return nd;

    const HeightMap& map = heightMap();
    const int W = map.width(), H = map.height();
    const int i = std::clamp(static_cast<int>((phi / (2 * PI) + 0.5f) * static_cast<float>(W)), 0, W - 1);
    const int j = std::clamp(static_cast<int>(theta / PI * static_cast<float>(H)), 0, H - 1);

    const float here = static_cast<float>(map.at(i, j));
    const float bu = static_cast<float>(map.at(i + 1 == W ? 0 : i + 1, j)) - here;
    const float bv = static_cast<float>(map.at(i, std::min(j + 1, H - 1))) - here;

    const V3f pu{{-n.c[2] / s, 0.0f, n.c[0] / s}};
    const V3f pv{{n.c[0] * n.c[1] / s, -s, n.c[2] * n.c[1] / s}};
    const V3f r = (n - pu * bu - pv * bv).unit();
    return Vector3(r.c[0], r.c[1], r.c[2]);
    // TASK T1 end
}

}  // namespace raytracer
