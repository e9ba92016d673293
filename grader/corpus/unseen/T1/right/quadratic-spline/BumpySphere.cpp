// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {
/// Weights of the three nearest knots of a uniform quadratic B-spline, and their derivatives.
struct Weights {
    double value[3];
    double slope[3];
    explicit Weights(double x)
        : value{0.5 * (0.5 - x) * (0.5 - x), 0.75 - x * x, 0.5 * (0.5 + x) * (0.5 + x)},
          slope{x - 0.5, -2.0 * x, x + 0.5} {}
};
}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 N = Sphere::getNormalAt(position);
    const HeightMap& m = heightMap();
    const double longitude = std::atan2(N.x, -N.z);
    const double polar = std::acos(std::clamp(N.y, -1.0, 1.0));
    const double s = (longitude / (2 * std::numbers::pi) + 0.5) * m.width();
    const double t = polar / std::numbers::pi * m.height();

    // texel that the point lies in, and the place inside of it from -1/2 to 1/2
    const int column = std::min(int(s), m.width() - 1), row = std::min(int(t), m.height() - 1);
    const Weights across{s - column - 0.5}, down{t - row - 0.5};

    double du = 0.0, dv = 0.0;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
            const int c = (column + i - 1 + m.width()) % m.width();
            const int r = std::clamp(row + j - 1, 0, m.height() - 1);
            du += across.slope[i] * down.value[j] * m.at(c, r);
            dv += across.value[i] * down.slope[j] * m.at(c, r);
        }

    const Vector3 right{std::cos(longitude), 0.0, std::sin(longitude)};
    const Vector3 down3{std::sin(longitude) * std::cos(polar), -std::sin(polar),
                        -std::cos(longitude) * std::cos(polar)};
    return (N - right * du - down3 * dv).normalised();
    // TASK T1 end
}

}  // namespace raytracer
