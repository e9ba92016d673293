// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <valarray>

namespace raytracer {

namespace {
/// epsilon_ijk for indices 0 to 2
int epsilon(int i, int j, int k) { return (i - j) * (j - k) * (k - i) / 2; }

std::valarray<double> product(const std::valarray<double>& a, const std::valarray<double>& b) {
    std::valarray<double> out(0.0, 3);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                out[i] += epsilon(i, j, k) * a[j] * b[k];
    return out;
}
}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    using Array = std::valarray<double>;
    const Vector3 c = centre();
    Array n{position.x - c.x, position.y - c.y, position.z - c.z};
    n /= std::sqrt((n * n).sum());

    const double phi = std::atan2(n[0], -n[2]);
    const double psi = std::asin(std::max(-1.0, std::min(1.0, n[1])));
    const int columns = heightMap().width(), rows = heightMap().height();
    const int i = std::min(columns - 1, int((phi + std::numbers::pi) / (2 * std::numbers::pi) * columns));
    const int k = std::min(rows - 1, int((0.5 - psi / std::numbers::pi) * rows));

    const double here = heightMap().at(i, k);
    const double bu = heightMap().at(i + 1 < columns ? i + 1 : 0, k) - here;
    const double bv = k + 1 < rows ? heightMap().at(i, k + 1) - here : 0.0;

    const Array pu{std::cos(phi), 0.0, std::sin(phi)};
    const Array pv{std::sin(phi) * std::sin(psi), -std::cos(psi), -std::cos(phi) * std::sin(psi)};
    Array m = n + bu * product(n, pv) - bv * product(n, pu);
    m /= std::sqrt((m * m).sum());
    return {m[0], m[1], m[2]};
    // TASK T1 end
}

}  // namespace raytracer
