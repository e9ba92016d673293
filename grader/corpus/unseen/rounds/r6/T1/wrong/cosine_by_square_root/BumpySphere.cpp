#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double sinT = std::sqrt(std::max(1e-20, n.x * n.x + n.z * n.z));
    const double cosT = std::sqrt(std::max(0.0, 1.0 - sinT * sinT));
    const double sinL = n.x / sinT, cosL = -n.z / sinT;
    const Vector3 Pu{cosL, 0.0, sinL};
    const Vector3 Pv{sinL * cosT, -sinT, -cosL * cosT};

    const HeightMap& hm = heightMap();
    const double u = 0.5 + std::atan2(sinL, cosL) / (2.0 * std::numbers::pi);
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const int i = std::min((int)(u * hm.width()), hm.width() - 1);
    const int j = std::min((int)(v * hm.height()), hm.height() - 1);
    const double h = hm.at(i, j);
    const double hr = hm.at(i == hm.width() - 1 ? 0 : i + 1, j);
    const double hd = j == hm.height() - 1 ? h : hm.at(i, j + 1);
    return (n - Pu * (hr - h) - Pv * (hd - h)).normalised();
}

}  // namespace raytracer
