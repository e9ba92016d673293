#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace glsl {

struct vec3 { float x, y, z; };
static vec3 operator+(vec3 a, vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
static vec3 operator-(vec3 a, vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
static vec3 operator*(float s, vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
static float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static vec3 cross(vec3 a, vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static vec3 normalize(vec3 a) { return (1.0f / std::sqrt(dot(a, a))) * a; }
static vec3 faceforward(vec3 n, vec3 i) { return dot(n, i) < 0 ? n : -1.0f * n; }

}  // namespace glsl

#define TEXEL(i, j) float(heightMap().at((i), (j)))

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    using namespace glsl;
    const Vector3 d = (position - centre()) / radius();
    const vec3 n = normalize({float(d.x), float(d.y), float(d.z)});
    const float PI = 3.14159265f;
    const float lon = std::atan2(n.z, n.x);
    const float lat = std::asin(std::fmin(1.f, std::fmax(-1.f, n.y)));
    const float u = lon / (2 * PI) + 0.5f;
    const float v = 0.5f - lat / PI;

    const vec3 Pu = {-std::sin(lon), 0, std::cos(lon)};
    const vec3 Pv = {std::cos(lon) * std::sin(lat), -std::cos(lat), std::sin(lon) * std::sin(lat)};
    const vec3 N = cross(Pv, Pu);  // looks inwards

    const int w = heightMap().width(), h = heightMap().height();
    int i = int(u * w); i = i < 0 ? 0 : i > w - 1 ? w - 1 : i;
    int j = int(v * h); j = j < 0 ? 0 : j > h - 1 ? h - 1 : j;
    const int i1 = i + 1 < w ? i + 1 : 0;
    const int j1 = j + 1 < h ? j + 1 : j;
    const float Bu = TEXEL(i1, j) - TEXEL(i, j);
    const float Bv = TEXEL(i, j1) - TEXEL(i, j);

    const vec3 perturbed = normalize(N + Bu * cross(N, Pv) - Bv * cross(N, Pu));
    const vec3 out = faceforward(perturbed, -1.0f * n);
    return Vector3{out.x, out.y, out.z}.normalised();
}

}  // namespace raytracer
