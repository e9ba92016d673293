// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

static double det3(const double m[3][3]) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

static void solve3(const double m[3][3], const double rhs[3], double x[3]) {
    const double d = det3(m);
    for (int k = 0; k < 3; ++k) {
        double c[3][3];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) c[i][j] = j == k ? rhs[i] : m[i][j];
        x[k] = det3(c) / d;
    }
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double a = std::atan2(n.x, -n.z);
    const double t = std::acos(std::min(1.0, std::max(-1.0, n.y)));
    const Vector3 e1(std::cos(a), 0.0, std::sin(a));
    const Vector3 e2(std::sin(a) * std::cos(t), -std::sin(t), -std::cos(a) * std::cos(t));

    int col = (int)((a + std::numbers::pi) / (2.0 * std::numbers::pi) * heightMap().width());
    int row = (int)(t / std::numbers::pi * heightMap().height());
    if (col > heightMap().width() - 1) col = heightMap().width() - 1;
    if (row > heightMap().height() - 1) row = heightMap().height() - 1;
    const double h0 = heightMap().at(col, row);
    const double hu = heightMap().at(col + 1 < heightMap().width() ? col + 1 : 0, row) - h0;
    const double hv = row + 1 < heightMap().height() ? heightMap().at(col, row + 1) - h0 : 0.0;

    const double M[3][3] = {{e1.x + hu * n.x, e1.y + hu * n.y, e1.z + hu * n.z},
                            {e2.x + hv * n.x, e2.y + hv * n.y, e2.z + hv * n.z},
                            {n.x, n.y, n.z}};
    const double rhs[3] = {0, 0, 1};
    double x[3];
    solve3(M, rhs, x);
    return Vector3(x[0], x[1], x[2]).normalised();
    // TASK T1 end
}

}  // namespace raytracer
