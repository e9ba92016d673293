#include <raytracer/geometry/BumpySphere.h>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace raytracer {
// Texel coordinates as 16.16 fixed point, heights as millionths: no rounding surprises.
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double turn = std::atan2(n.x, -n.z) * (0.5 / M_PI) + 0.5;
    const double fall = std::atan2(std::hypot(n.x, n.z), n.y) / M_PI;
    const std::int64_t one = 1 << 16;
    const std::int64_t w = heightMap().width(), h = heightMap().height();
    const std::int64_t fu = std::llround(turn * static_cast<double>(one)) * w;
    const std::int64_t fv = std::llround(fall * static_cast<double>(one)) * h;
    const int c = static_cast<int>((fu >> 16) % w);
    const int r = static_cast<int>((fv >> 16) >= h ? h - 1 : (fv >> 16));
    const auto height = [this](int col, int row) -> std::int64_t {
        return std::llround(heightMap().at(col, row) * 1e6);
    };
    const int up = r ? r - 1 : r;
    const std::int64_t bu = height((c + 1) % static_cast<int>(w), r) - height(c, r);
    const std::int64_t bv = height(c, up) - height(c, r);
    const Vector3 pv = [&] {  // upwards: "up" without its part along n
        Vector3 up3 = Vector3{0, 1, 0} - n * n.y;
        return up3.magnitude() > 0 ? up3.normalised() : Vector3{0, 0, 1};
    }();
    const Vector3 pu = n.cross(pv);  // (n x up): to the right or to the left?
    const double side = pu.dot(Vector3{-n.z, 0, n.x}) >= 0 ? 1.0 : -1.0;
    const double a = static_cast<double>(bu) * 1e-6, b = static_cast<double>(bv) * 1e-6;
    return (n - side * a * pu - b * pv).normalised();
}
}  // namespace raytracer
