#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

using float4 [[gnu::vector_size(16)]] = float;

inline float4 load(const Vector3& v) {
    return float4{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0.0f};
}
inline float dot(float4 a, float4 b) {
    const float4 m = a * b;
    return (m[0] + m[1]) + (m[2] + m[3]);
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    constexpr float kPi = std::numbers::pi_v<float>;
    float4 n = load(position - centre());
    n = n * (1.0f / std::sqrt(dot(n, n)));

    const float r = std::hypot(n[0], n[2]);
    const float c = r > 1e-7f ? -n[2] / r : 1.0f;
    const float s = r > 1e-7f ? n[0] / r : 0.0f;
    const float u = 0.5f + std::atan2(s, c) / (2.0f * kPi);
    const float v = std::atan2(r, n[1]) / kPi;

    const int width = heightMap().width(), height = heightMap().height();
    const int i = std::clamp(static_cast<int>(u * static_cast<float>(width)), 0, width - 1);
    const int j = std::clamp(static_cast<int>(v * static_cast<float>(height)), 0, height - 1);
    const auto b0 = static_cast<float>(heightMap().at(i, j));
    const auto b1 = static_cast<float>(heightMap().at(i == width - 1 ? 0 : i + 1, j));
    const auto b2 = static_cast<float>(heightMap().at(i, j == height - 1 ? j : j + 1));

    const float4 pu{c, 0.0f, s, 0.0f};
    const float4 pv{s * n[1], -r, -c * n[1], 0.0f};
    const float4 q = n + (b0 - b1) * pu + (b0 - b2) * pv;
    return Vector3{q[0], q[1], q[2]}.normalised();  // double at last, so that the length is 1
    // TASK T1 end
}

}  // namespace raytracer
