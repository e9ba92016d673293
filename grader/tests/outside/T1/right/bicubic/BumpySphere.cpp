#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

static void weights(double t, double w[4], double d[4]) {
    w[0] = ((-t + 2) * t - 1) * t / 2; w[1] = ((3 * t - 5) * t * t + 2) / 2;
    w[2] = ((-3 * t + 4) * t + 1) * t / 2; w[3] = (t - 1) * t * t / 2;
    d[0] = (-3 * t * t + 4 * t - 1) / 2; d[1] = (9 * t * t - 10 * t) / 2;
    d[2] = (-9 * t * t + 8 * t + 1) / 2; d[3] = (3 * t * t - 2 * t) / 2;
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = (position - centre()).normalised();
    const double phi = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int W = heightMap().width(), H = heightMap().height();
    const double x = (phi / (2 * std::numbers::pi) + 1) * W - 0.5, y = theta / std::numbers::pi * H - 0.5;
    double wx[4], dx[4], wy[4], dy[4], bu = 0, bv = 0;
    weights(x - std::floor(x), wx, dx);
    weights(y - std::floor(y), wy, dy);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const int c = (int(std::floor(x)) + i - 1 + W) % W, r = std::clamp(int(std::floor(y)) + j - 1, 0, H - 1);
            bu += dx[i] * wy[j] * heightMap().at(c, r);
            bv += wx[i] * dy[j] * heightMap().at(c, r);
        }
    const Vector3 pu{std::cos(phi), 0, std::sin(phi)};
    const Vector3 pv{std::cos(theta) * std::sin(phi), -std::sin(theta), -std::cos(theta) * std::cos(phi)};
    return (n - 2 * bu * pu - 2 * bv * pv).normalised();
}

}  // namespace raytracer
