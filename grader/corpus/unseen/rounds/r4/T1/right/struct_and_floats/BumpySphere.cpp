#include <raytracer/geometry/BumpySphere.h>
#include <cmath>

namespace raytracer {

struct Vec {
    float x, y, z;
    Vec(float a, float b, float c) { x = a; y = b; z = c; }
    float length() { return sqrtf(x * x + y * y + z * z); }
    void addScaled(Vec other, float k) {
        x += other.x * k;
        y += other.y * k;
        z += other.z * k;
    }
};

struct Texel {
    int column;
    int row;
};

Texel findTexel(float u, float v, const HeightMap& map) {
    Texel t;
    t.column = (int)(u * (float)map.width());
    t.row = (int)(v * (float)map.height());
    if (t.column >= map.width()) t.column = map.width() - 1;
    if (t.row >= map.height()) t.row = map.height() - 1;
    return t;
}

float slopeRight(const HeightMap& map, Texel t) {
    Texel next = t;
    next.column++;
    if (next.column == map.width()) next.column = 0;
    return (float)(map.at(next.column, next.row) - map.at(t.column, t.row));
}

float slopeDown(const HeightMap& map, Texel t) {
    Texel next = t;
    next.row++;
    if (next.row == map.height()) next.row--;
    return (float)(map.at(next.column, next.row) - map.at(t.column, t.row));
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const float pi = 3.14159265f;
    Vector3 smooth = Sphere::getNormalAt(position);
    float a = atan2f((float)smooth.x, (float)-smooth.z);
    float c = (float)smooth.y;
    if (c > 1.0f) c = 1.0f;
    if (c < -1.0f) c = -1.0f;
    float b = acosf(c);
    float u = (a + pi) / (2.0f * pi);
    float v = b / pi;
    if (u < 0.0f) u = 0.0f;

    Texel t = findTexel(u, v, heightMap());
    Vec tilted((float)smooth.x, (float)smooth.y, (float)smooth.z);
    tilted.addScaled(Vec(cosf(a), 0.0f, sinf(a)), -slopeRight(heightMap(), t));
    tilted.addScaled(Vec(sinf(a) * cosf(b), -sinf(b), -cosf(a) * cosf(b)), -slopeDown(heightMap(), t));

    Vector3 answer(tilted.x, tilted.y, tilted.z);
    return answer.normalised();
}

}  // namespace raytracer
