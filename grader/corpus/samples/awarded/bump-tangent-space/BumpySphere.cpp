#include <raytracer/geometry/BumpySphere.h>

#include <array>
#include <cmath>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const double pi = std::acos(-1.0);
    const Vector3 d = (position - centre()) * (1.0 / radius());
    const auto W = heightMap().width();
    const auto H = heightMap().height();
    const auto texel = [&](double u, double vUp) {
        const int c = static_cast<int>(std::floor(u * W));
        const int r = H - 1 - static_cast<int>(std::floor(vUp * H));
        return heightMap().at(((c % W) + W) % W, r < 0 ? 0 : (r > H - 1 ? H - 1 : r));
    };
    const double u = 0.5 + std::atan2(d.x, -d.z) / (2 * pi);
    const double v = 0.5 + std::asin(std::fmax(-1.0, std::fmin(1.0, d.y))) / pi;
    const double du = 1.0 / W, dv = 1.0 / H;
    const std::array<double, 3> local{-2.0 * (texel(u + du, v) - texel(u - du, v)),
                                      -2.0 * (texel(u, v + dv) - texel(u, v - dv)), 1.0};

    const double lon = (u - 0.5) * 2 * pi, lat = (v - 0.5) * pi;
    const Vector3 T{std::cos(lon), 0, std::sin(lon)};
    const Vector3 B{-std::sin(lon) * std::sin(lat), std::cos(lat), std::cos(lon) * std::sin(lat)};
    const Vector3 N = d.normalised();
    const Vector3 world{T.x * local[0] + B.x * local[1] + N.x * local[2],
                        T.y * local[0] + B.y * local[1] + N.y * local[2],
                        T.z * local[0] + B.z * local[1] + N.z * local[2]};
    return world / world.magnitude();
}

}  // namespace raytracer
