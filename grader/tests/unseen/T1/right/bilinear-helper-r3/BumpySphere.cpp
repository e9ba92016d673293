// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {
// from learnopengl forum, adapted (GL_REPEAT in s, GL_CLAMP_TO_EDGE in t)
double texture2D(const HeightMap& tex, double s, double t) {
    double fx = s * tex.width() - 0.5, fy = t * tex.height() - 0.5;
    double x0 = std::floor(fx), y0 = std::floor(fy);
    double ax = fx - x0, ay = fy - y0;
    auto fetch = [&](double cx, double cy) {
        int c = (int)cx % tex.width();
        if (c < 0) c += tex.width();
        int r = std::clamp((int)cy, 0, tex.height() - 1);
        return tex.at(c, r);
    };
    double top = fetch(x0, y0) * (1 - ax) + fetch(x0 + 1, y0) * ax;
    double bot = fetch(x0, y0 + 1) * (1 - ax) + fetch(x0 + 1, y0 + 1) * ax;
    return top * (1 - ay) + bot * ay;
}
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 N = Sphere::getNormalAt(position);
    double u = std::atan2(N.x, -N.z) / (2 * std::numbers::pi) + 0.5;
    double v = std::acos(std::clamp(N.y, -1.0, 1.0)) / std::numbers::pi;
    Vector3 up(0, 1, 0);
    Vector3 T = N.cross(up);                       // left handed => to the right
    if (T.magnitude() < 1e-12) T = Vector3(1, 0, 0);  // poles
    T = T.normalised();
    Vector3 B = N.cross(T);                        // down
    double dx = 1.0 / heightMap().width();
    double dy = 1.0 / heightMap().height();
    double dBu = texture2D(heightMap(), u + dx, v) - texture2D(heightMap(), u, v);
    double dBv = texture2D(heightMap(), u, v + dy) - texture2D(heightMap(), u, v);
    // T x B = N -> equation 2
    return (N + dBu * (N.cross(B)) - dBv * (N.cross(T))).normalised();
    // TASK T1 end
}

}  // namespace raytracer
