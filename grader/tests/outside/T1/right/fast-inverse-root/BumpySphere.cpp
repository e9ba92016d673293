#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <cstdint>
#include <cstring>

namespace raytracer {

static float rsqrt(float x) {
    std::uint32_t i;
    float y;
    std::memcpy(&i, &x, 4);
    i = 0x5f3759df - (i >> 1);
    std::memcpy(&y, &i, 4);
    y *= 1.5f - 0.5f * x * y * y;
    y *= 1.5f - 0.5f * x * y * y;
    return y;
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    float x = float(position.x - centre().x), y = float(position.y - centre().y), z = float(position.z - centre().z);
    float k = rsqrt(x * x + y * y + z * z);
    x *= k; y *= k; z *= k;
    const float PI = 3.14159265f;
    float u = 0.5f - std::atan2(x, z) / (2 * PI);
    float v = std::acos(std::fmax(-1.f, std::fmin(1.f, y))) / PI;
    int W = heightMap().width(), H = heightMap().height();
    int c = int(u * float(W - 1)), r = int(v * float(H - 1));
    float h = float(heightMap().at(c, r));
    float bu = float(heightMap().at(c + 1 < W ? c + 1 : 0, r)) - h;
    float bv = float(heightMap().at(c, r + 1 < H ? r + 1 : H - 1)) - h;
    float s = std::sqrt(x * x + z * z);
    if (s < 1e-6f) return {x, y, z};
    float ux = -z / s, uz = x / s;
    float vx = x * y / s, vy = -s, vz = z * y / s;
    x -= bu * ux + bv * vx; y -= bv * vy; z -= bu * uz + bv * vz;
    k = rsqrt(x * x + y * y + z * z);
    return {x * k, y * k, z * k};
}

}  // namespace raytracer
