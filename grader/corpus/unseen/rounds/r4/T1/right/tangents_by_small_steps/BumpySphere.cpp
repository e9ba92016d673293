// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

// point of the unit sphere for u and v in 0..1
Vector3 pointAt(double u, double v) {
    double a = 2.0 * std::numbers::pi * (u - 0.5);
    double b = std::numbers::pi * v;
    return Vector3(std::sin(a) * std::sin(b), std::cos(b), -std::cos(a) * std::sin(b));
}

// the other way round
void toUV(const Vector3& n, double& u, double& v) {
    u = std::atan2(n.x, -n.z) / (2.0 * std::numbers::pi) + 0.5;
    v = std::acos(std::max(-1.0, std::min(1.0, n.y))) / std::numbers::pi;
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 n = Sphere::getNormalAt(position);
    double u, v;
    toUV(n, u, v);
    const double d = 1e-5;

    // tangents: move a little and see where the point goes
    Vector3 Pu = (pointAt(u + d, v) - pointAt(u - d, v)).normalised();
    Vector3 Pv = (pointAt(u, v + d) - pointAt(u, v - d)).normalised();

    int w = heightMap().width();
    int h = heightMap().height();
    int x = std::min(int(u * w), w - 1);
    int y = std::min(int(v * h), h - 1);
    int x1 = (x + 1) % w;
    int y1 = std::min(y + 1, h - 1);
    double Bu = heightMap().at(x1, y) - heightMap().at(x, y);
    double Bv = heightMap().at(x, y1) - heightMap().at(x, y);

    // which sign? ask the cross product
    if (Pu.cross(Pv).dot(n) > 0) {
        return (n + Bu * n.cross(Pv) - Bv * n.cross(Pu)).normalised();
    } else {
        return (n - Bu * n.cross(Pv) + Bv * n.cross(Pu)).normalised();
    }
    // TASK T1 end
}

}  // namespace raytracer
