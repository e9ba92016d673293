// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z);
    const double pol = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int w = heightMap().width();
    const int h = heightMap().height();
    const double s = (lon / (2 * std::numbers::pi) + 0.5) * w - 0.5;
    const double t = pol / std::numbers::pi * h - 0.5;
    const int i = (int)std::floor(s);
    const int j = (int)std::floor(t);
    const double fs = s - i;
    const double ft = t - j;

    const int left = (i + w) % w;
    const int right = (i + 1 + w) % w;
    const int top = std::clamp(j, 0, h - 1);
    const int bottom = std::clamp(j + 1, 0, h - 1);
    const double a = heightMap().at(left, top);
    const double b = heightMap().at(right, top);
    const double c = heightMap().at(left, bottom);
    const double d = heightMap().at(right, bottom);

    // slopes of the bilinear patch
    const double Bu = (b - a) * (1 - ft) + (c - d) * ft;
    const double Bv = (c - a) * (1 - fs) + (d - b) * fs;

    const Vector3 Pu{std::cos(lon), 0, std::sin(lon)};
    const Vector3 Pv{std::sin(lon) * std::cos(pol), -std::sin(pol), -std::cos(lon) * std::cos(pol)};
    return (n - Bu * Pu - Bv * Pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
