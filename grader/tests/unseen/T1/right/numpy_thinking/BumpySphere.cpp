#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace np {  // what I would have imported
using array3 = std::array<double, 3>;
static double clip(double v, double lo, double hi) { return std::fmin(std::fmax(v, lo), hi); }
static int mod(int a, int n) { return ((a % n) + n) % n; }
static double dot(const array3& a, const array3& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}
static double norm(const array3& a) { return std::sqrt(dot(a, a)); }
static array3 axpy(double k, const array3& x, array3 y) {
    for (int i = 0; i < 3; ++i) y[i] += k * x[i];
    return y;
}
}  // namespace np

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const auto smooth = Sphere::getNormalAt(position);
    const np::array3 n{smooth.x, smooth.y, smooth.z};
    const auto [nx, ny, nz] = n;

    const auto lon = std::atan2(nz, nx);                        // 0 at the right, 90 degrees behind
    const auto colat = std::acos(np::clip(ny, -1, 1));
    const auto [rows, cols] = std::array{heightMap().height(), heightMap().width()};
    // seen from outside, lon grows to the right: at the front lon = -90 degrees, on the right 0
    const auto col = np::mod(static_cast<int>(std::floor(lon / (2 * std::numbers::pi) * cols)), cols);
    const auto row = static_cast<int>(np::clip(std::floor(colat / std::numbers::pi * rows), 0, rows - 1));

    const auto at = [&](int r, int c) { return heightMap().at(np::mod(c, cols), std::min(r, rows - 1)); };
    const auto db_dcol = at(row, col + 1) - at(row, col);
    const auto db_drow = at(row + 1, col) - at(row, col);

    const np::array3 right{-std::sin(lon), 0, std::cos(lon)};
    const np::array3 down{std::cos(lon) * std::cos(colat), -std::sin(colat), std::sin(lon) * std::cos(colat)};

    auto out = np::axpy(-db_drow, down, np::axpy(-db_dcol, right, n));
    const auto length = np::norm(out);
    for (auto& o : out) o /= length;
    return {out[0], out[1], out[2]};
    // TASK T1 end
}

}  // namespace raytracer
