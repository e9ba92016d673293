#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace raytracer;

static double sampleHeight(const HeightMap& m, Vector3 d) {
    d = d.normalised();
    const double u = 0.75 + std::atan2(d.z, d.x) / (2 * std::numbers::pi);
    const double v = std::acos(std::clamp(d.y, -1.0, 1.0)) / std::numbers::pi;
    const double x = (u - std::floor(u)) * m.width();
    const double y = std::clamp(v * m.height(), 0.5, m.height() - 0.5);
    const int x0 = static_cast<int>(std::floor(x - 0.5));
    const int y0 = std::clamp(static_cast<int>(std::floor(y - 0.5)), 0, m.height() - 2);
    const double fx = x - 0.5 - x0, fy = y - 0.5 - y0;
    const int w = m.width();
    const int xa = (x0 + w) % w, xb = (x0 + 1 + w) % w;
    return std::lerp(std::lerp(m.at(xa, y0), m.at(xb, y0), fx),
                     std::lerp(m.at(xa, y0 + 1), m.at(xb, y0 + 1), fx), fy);
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z), b = n.x * n.y * a;
    const Vector3 t1{1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    const Vector3 t2{b, sign + n.y * n.y * a, -n.y};
    const double e = std::numbers::pi / heightMap().height();
    const double g1 = (sampleHeight(heightMap(), n + e * t1) - sampleHeight(heightMap(), n - e * t1)) / (2 * e);
    const double g2 = (sampleHeight(heightMap(), n + e * t2) - sampleHeight(heightMap(), n - e * t2)) / (2 * e);
    return (n - 0.01 * (g1 * t1 + g2 * t2)).normalised();
}
