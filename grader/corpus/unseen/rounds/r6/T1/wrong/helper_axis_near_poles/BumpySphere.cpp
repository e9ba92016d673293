#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    // pick the helper that is not parallel to n
    const Vector3 helper = std::abs(n.y) > 0.6 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
    const Vector3 tangent = n.cross(helper).normalised();
    const Vector3 bitangent = n.cross(tangent);
    const HeightMap& hm = heightMap();
    const double u = std::atan2(n.x, -n.z) / (2 * std::numbers::pi) + 0.5;
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const int c = std::min(int(u * hm.width()), hm.width() - 1);
    const int r = std::min(int(v * hm.height()), hm.height() - 1);
    const double h = hm.at(c, r);
    const double du = hm.at((c + 1) % hm.width(), r) - h;
    const double dv = hm.at(c, std::min(r + 1, hm.height() - 1)) - h;
    return (n - tangent * du - bitangent * dv).normalised();
}

}  // namespace raytracer
