// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <iostream>

namespace raytracer {

//#define DEBUG_BUMP 1
static const int DX[2] = {1, 0};
static const int DY[2] = {0, 1};

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 n = Sphere::getNormalAt(position);
    double phi = std::atan2(n.x, -n.z), theta = std::acos(n.y >= 1 ? 1 : n.y <= -1 ? -1 : n.y);
    double uv[2] = {phi / (2.0 * std::numbers::pi), theta / std::numbers::pi};
    uv[0] = uv[0] - std::floor(uv[0]);          // u begins in front
    int size[2] = {heightMap().width(), heightMap().height()};
    int at[2];
    for (int k = 0; k < 2; k++) {
        at[k] = (int)(uv[k] * size[k]);
        if (at[k] >= size[k]) at[k] = size[k] - 1;
    }
    Vector3 tilted = n;
    for (int k = 0; k < 2; k++) {
        int c = at[0] + DX[k], r = at[1] + DY[k];
        if (c >= size[0]) c -= size[0];
        if (r >= size[1]) continue;             // nothing below
        double b = heightMap().at(c, r) - heightMap().at(at[0], at[1]);
        Vector3 p;
        switch (k) {
            case 0: p = {std::cos(phi), 0, std::sin(phi)}; break;
            case 1: p = {std::sin(phi) * std::cos(theta), -std::sin(theta), -std::cos(phi) * std::cos(theta)}; break;
        }
#ifdef DEBUG_BUMP
        std::cerr << k << " b=" << b << "\n";
#endif
        tilted -= p * b;
    }
    tilted /= tilted.magnitude();
    return tilted;
    // TASK T1 end
}

}  // namespace raytracer
