// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

int wrapped(int i, int n) {
    if (i < 0) return wrapped(i + n, n);
    if (i >= n) return wrapped(i - n, n);
    return i;
}

int byteAt(const HeightMap& map, int column, int row) {
    row = std::clamp(row, 0, map.height() - 1);
    return static_cast<int>(std::lround(map.at(wrapped(column, map.width()), row) / kBumpFactor * 255));
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const auto pointAt = [](double u, double v) {
        const double a = 2 * std::numbers::pi * u, t = std::numbers::pi * v;
        return Vector3{std::sin(t) * std::cos(a), std::cos(t), std::sin(t) * std::sin(a)};
    };
    const double u = std::atan2(n.z, n.x) / (2 * std::numbers::pi);
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;

    constexpr double step = 1e-6;
    Vector3 pu = pointAt(u + step, v) - pointAt(u - step, v);
    Vector3 pv = pointAt(u, v + step) - pointAt(u, v - step);
    if (pu.magnitude() < 1e-13) return n;  // a pole
    pu = pu.normalised();
    pv = pv.normalised();

    const int column = static_cast<int>(std::floor(u * heightMap().width()));
    const int row = static_cast<int>(v * heightMap().height());
    const int here = byteAt(heightMap(), column, row);
    const int eastwards = byteAt(heightMap(), column + 1, row) - here;
    const int southwards = byteAt(heightMap(), column, row + 1) - here;
    pu += n * (eastwards / 51.0);
    pv += n * (southwards / 51.0);
    return pu.cross(pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
