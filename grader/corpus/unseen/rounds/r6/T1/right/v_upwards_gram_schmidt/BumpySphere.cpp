#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const Vector3 up{0, 1, 0};
    Vector3 Pv = up - n * up.dot(n);  // up, without its part along n
    const double length = Pv.magnitude();
    Pv = length > 1e-10 ? Pv / length : Vector3{0, 0, 1};
    const Vector3 Pu = n.cross(Pv);   // right x up = -n here, so n x up is the right

    const double u = 0.5 + 0.5 * std::atan2(n.x, -n.z) / std::numbers::pi;
    const double v = 1.0 - std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const HeightMap& map = heightMap();
    const int W = map.width(), H = map.height();
    const auto height = [&](int i, int storey) {  // storey 0 is the picture's lowest row
        return map.at(((i % W) + W) % W, H - 1 - storey);
    };
    const int i = std::min(int(u * W), W - 1);
    const int k = std::min(int(v * H), H - 1);
    const double Bu = height(i + 1, k) - height(i, k);
    const double Bv = k + 1 < H ? height(i, k + 1) - height(i, k) : 0.0;
    return (n - Bu * n.cross(Pv) * (Pu.cross(Pv).dot(n) > 0 ? -1.0 : 1.0)
              + Bv * n.cross(Pu) * (Pu.cross(Pv).dot(n) > 0 ? -1.0 : 1.0)).normalised();
}

}  // namespace raytracer
