#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 q = position - centre();
    const double rr = q.dot(q), r = std::sqrt(rr);
    const double ss = std::max(q.x * q.x + q.z * q.z, 1e-14 * rr), s = std::sqrt(ss);

    // lambda = atan2(x, -z), theta = acos(y / r): differentiate by x, y, z.
    const Vector3 gradLambda = Vector3{-q.z, 0.0, q.x} / ss;
    const Vector3 gradTheta = Vector3{q.x * q.y, -ss, q.z * q.y} / (rr * s);

    const double turn = std::atan2(q.x, -q.z) / (2.0 * std::numbers::pi);  // -1/2 .. 1/2
    const double fall = std::acos(std::clamp(q.y / r, -1.0, 1.0)) / std::numbers::pi;

    const HeightMap& h = heightMap();
    const double a = (turn + 0.5) * h.width(), b = fall * h.height();
    const int c = std::min(static_cast<int>(a), h.width() - 1);
    const int d = std::min(static_cast<int>(b), h.height() - 1);
    const double dhda = h.at((c + 1) % h.width(), d) - h.at(c, d);
    const double dhdb = d + 1 < h.height() ? h.at(c, d + 1) - h.at(c, d) : 0.0;

    // chain rule; the angle of a texel is taken out again, so that a texel's step counts 1
    const Vector3 grad = gradLambda * (dhda * s) + gradTheta * (dhdb * r);
    return (q / r - grad).normalised();
}

}  // namespace raytracer
