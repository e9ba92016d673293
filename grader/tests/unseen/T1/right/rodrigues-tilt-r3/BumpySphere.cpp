#include <raytracer/geometry/BumpySphere.h>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {
// rotate v around unit axis k by a, from wikipedia
Vector3 rodrigues(const Vector3& v, const Vector3& k, double a) {
    return v * std::cos(a) + k.cross(v) * std::sin(a) + k * (k.dot(v) * (1 - std::cos(a)));
}
int mod(int a, int b) { return (a % b + b) % b; }
}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const auto smooth = Sphere::getNormalAt(position);
    const auto horizontal = std::hypot(smooth.x, smooth.z);
    const auto polar = std::atan2(horizontal, smooth.y);       // same as acos(y), but no clamp needed
    const auto turn = std::atan2(smooth.z, smooth.x);          // starts at +x, anticlockwise from above?
    // seen from outside x -> right at the front means turn goes -pi..0, so growing = to the right. good
    const auto u = turn / (2 * std::numbers::pi);              // -0.5 .. 0.5, mod() below repairs it
    const auto& m = heightMap();
    const int i = mod(static_cast<int>(std::floor(u * m.width())), m.width());
    int j = static_cast<int>(polar / std::numbers::pi * m.height());
    if (j == m.height()) --j;
    const double h0 = m.at(i, j);
    const double su = m.at(mod(i + 1, m.width()), j) - h0;
    const double sv = j + 1 == m.height() ? 0.0 : m.at(i, j + 1) - h0;

    const double steep = std::hypot(su, sv);
    if (steep == 0) return smooth;
    const Vector3 right{-std::sin(turn), 0, std::cos(turn)};
    const Vector3 down{std::cos(turn) * smooth.y, -horizontal, std::sin(turn) * smooth.y};
    const Vector3 uphill = (right * su + down * sv) / steep;
    const Vector3 axis = smooth.cross(uphill);       // turning around it by + goes towards uphill
    return rodrigues(smooth, axis, -std::atan(steep)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
