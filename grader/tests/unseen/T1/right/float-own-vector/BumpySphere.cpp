// Everything in float, with a little vector type of my own that looks like GLSL.
#include <raytracer/geometry/BumpySphere.h>

#include <cmath>

namespace {

struct vec3 {
    float x, y, z;
};
inline vec3 operator+(vec3 a, vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline vec3 operator-(vec3 a, vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline vec3 operator*(float s, vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline vec3 normalize(vec3 a) { return (1.0f / std::sqrt(dot(a, a))) * a; }
inline float saturate(float f) { return f < 0 ? 0 : f > 1 ? 1 : f; }

constexpr float PI = 3.14159265f;

}  // namespace

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const float R = (float)radius();
    vec3 n = {(float)((position.x - centre().x) / R), (float)((position.y - centre().y) / R),
              (float)((position.z - centre().z) / R)};
    n = normalize(n);

    // u starts at the left edge of the sphere as the camera sees it
    float lon = std::atan2(-n.z, -n.x);
    if (lon < 0) lon += 2 * PI;
    float u = saturate(lon / (2 * PI));
    float v = saturate(std::acos(2 * saturate(0.5f + 0.5f * n.y) - 1) / PI);

    vec3 Pu = {std::sin(lon), 0, -std::cos(lon)};
    vec3 Pv = {-std::cos(lon) * n.y, -std::sqrt(std::fmax(0.0f, 1 - n.y * n.y)),
               -std::sin(lon) * n.y};

    const HeightMap& map = heightMap();
    int i = (int)(u * map.width());
    int j = (int)(v * map.height());
    if (i == map.width()) i = 0;
    if (j == map.height()) --j;
    int iNext = i + 1 == map.width() ? 0 : i + 1;
    int jNext = j + 1 == map.height() ? j : j + 1;

    float h = (float)map.at(i, j);
    float Bu = (float)map.at(iNext, j) - h;
    float Bv = (float)map.at(i, jNext) - h;

    vec3 m = normalize(n - Bu * Pu - Bv * Pv);
    return Vector3(m.x, m.y, m.z).normalised();
    // TASK T1 end
}

}  // namespace raytracer
