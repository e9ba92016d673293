// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <array>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 smooth = Sphere::getNormalAt(position);
    const HeightMap& map = heightMap();
    const double lon = std::atan2(smooth.x, -smooth.z);
    const double pol = std::acos(std::clamp(smooth.y, -1.0, 1.0));
    const int i = std::min(int((0.5 + lon / 2 / std::numbers::pi) * map.width()), map.width() - 1);
    const int j = std::min(int(pol / std::numbers::pi * map.height()), map.height() - 1);

    // h = a + b p + c q over p, q in -1..1
    std::array<std::array<double, 4>, 3> m{};
    for (int q = -1; q <= 1; ++q)
        for (int p = -1; p <= 1; ++p) {
            if (j + q < 0 || j + q >= map.height()) continue;  // nothing there to fit
            const double h = map.at((i + p + map.width()) % map.width(), j + q);
            const std::array<double, 4> row{1.0, double(p), double(q), h};
            for (int r = 0; r < 3; ++r)
                for (int k = 0; k < 4; ++k)
                    m[r][k] += row[r] * row[k];
        }
    for (int r = 0; r < 3; ++r)
        for (int below = 0; below < 3; ++below) {
            if (below == r) continue;
            const double f = m[below][r] / m[r][r];
            for (int k = r; k < 4; ++k)
                m[below][k] -= f * m[r][k];
        }
    const double b = m[1][3] / m[1][1], c = m[2][3] / m[2][2];

    const Vector3 east{std::cos(lon), 0.0, std::sin(lon)};
    const Vector3 south{std::sin(lon) * std::cos(pol), -std::sin(pol), -std::cos(lon) * std::cos(pol)};
    return (smooth + b * smooth.cross(south) - c * smooth.cross(east)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
