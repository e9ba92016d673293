#include <raytracer/geometry/BumpySphere.h>
#include <cmath>

namespace raytracer {
static float deg(float rad) {
    return rad * 57.29577951f;
}
static float rad(float d) {
    return d / 57.29577951f;
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 nd = Sphere::getNormalAt(position);
    const float nx = static_cast<float>(nd.x), ny = static_cast<float>(nd.y),
                nz = static_cast<float>(nd.z);
    float lon = deg(atan2f(nx, -nz));                             // -180 .. 180
    if (lon < 0.0f) lon += 360.0f;                                // 0 .. 360, front is 0
    const float lat = deg(asinf(fminf(1.0f, fmaxf(-1.0f, ny))));  // -90 .. 90

    const int w = heightMap().width(), h = heightMap().height();
    const int col = static_cast<int>(lon / 360.0f * static_cast<float>(w)) % w;
    int row = static_cast<int>((90.0f - lat) / 180.0f * static_cast<float>(h));
    if (row > h - 1) row = h - 1;

    // central differences
    const int l = (col + w - 1) % w, r = (col + 1) % w;
    const int t = row > 0 ? row - 1 : 0, b = row < h - 1 ? row + 1 : h - 1;
    const float du = static_cast<float>(heightMap().at(r, row) - heightMap().at(l, row)) * 0.5f;
    const float dv = static_cast<float>(heightMap().at(col, b) - heightMap().at(col, t)) * 0.5f;

    const float cl = cosf(rad(lon)), sl = sinf(rad(lon)), cp = cosf(rad(lat)), sp = sinf(rad(lat));
    // right = (cl, 0, sl), down = (sl*sp, -cp, -cl*sp)
    float x = nx - du * cl - dv * sl * sp;
    float y = ny + dv * cp;
    float z = nz - du * sl + dv * cl * sp;
    const float inv = 1.0f / sqrtf(x * x + y * y + z * z);
    return Vector3{static_cast<double>(x * inv), static_cast<double>(y * inv),
                   static_cast<double>(z * inv)};
}
}  // namespace raytracer
