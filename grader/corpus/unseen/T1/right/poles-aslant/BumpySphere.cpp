#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const Vector3 a{1, 0, 0}, b{0, -0.6, 0.8}, pole{0, 0.8, 0.6};
    const double lambda = std::atan2(n.dot(b), n.dot(a)), theta = std::acos(std::clamp(n.dot(pole), -1.0, 1.0));
    const int W = heightMap().width(), H = heightMap().height();
    const int c = std::min(W - 1, int((lambda / (2 * std::numbers::pi) + 0.5) * W)), r = std::min(H - 1, int(theta / std::numbers::pi * H));
    const double bu = heightMap().at((c + 1) % W, r) - heightMap().at(c, r);
    const double bv = heightMap().at(c, std::min(H - 1, r + 1)) - heightMap().at(c, r);
    const Vector3 pu = b * std::cos(lambda) - a * std::sin(lambda);
    const Vector3 pv = (a * std::cos(lambda) + b * std::sin(lambda)) * std::cos(theta) - pole * std::sin(theta);
    return (n - pu * bu - pv * bv).normalised();
    // TASK T1 end
}
}  // namespace raytracer
