#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace raytracer {

// The map stands with its top row at the sphere's right-hand end; heights are blurred before they
// are differentiated.
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double around = std::atan2(n.z, n.y);
    const double along = std::acos(std::min(1.0, std::max(-1.0, n.x)));

    // Binomial weights by recursion: a blur of order k is the mean of two of order k - 1.
    const std::function<double(double, double, int)> blurred = [&](double c, double r,
                                                                   int order) -> double {
        if (order == 0) {
            const int w = heightMap().width();
            const int h = heightMap().height();
            const int column = static_cast<int>(std::floor(c));
            const int row = static_cast<int>(std::floor(r));
            return heightMap().at((column % w + w) % w, std::clamp(row, 0, h - 1));
        }
        const double half = 0.5;
        return 0.25 * (blurred(c - half, r - half, order - 1) + blurred(c + half, r - half, order - 1) +
                       blurred(c - half, r + half, order - 1) + blurred(c + half, r + half, order - 1));
    };

    const double c = (around / (2.0 * std::numbers::pi) + 0.5) * heightMap().width();
    const double r = along / std::numbers::pi * heightMap().height();
    const double bu = blurred(c + 1.0, r, 2) - blurred(c - 1.0, r, 2);
    const double bv = blurred(c, r + 1.0, 2) - blurred(c, r - 1.0, 2);

    const Vector3 pu{0.0, -std::sin(around), std::cos(around)};
    const Vector3 pv{-std::sin(along), std::cos(along) * std::cos(around),
                     std::cos(along) * std::sin(around)};
    Vector3 tilted = n;
    tilted = tilted - pu * bu;
    tilted = tilted - pv * bv;
    return tilted.normalised();
}

}  // namespace raytracer
