// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 n = Sphere::getNormalAt(position);
    double nx = n.x;
    double ny = n.y;
    double nz = n.z;
    double pi = 3.14159265358979;

    // angles
    double phi = std::atan2(nx, -nz);
    if (phi < 0) {
        phi = phi + 2 * pi;
    }
    if (ny > 1) ny = 1;
    if (ny < -1) ny = -1;
    double theta = std::acos(ny);

    // u and v
    double u = phi / (2 * pi);
    double v = theta / pi;

    // tangent u
    double pux = std::cos(phi);
    double puy = 0;
    double puz = std::sin(phi);
    // tangent v
    double pvx = std::cos(theta) * std::sin(phi);
    double pvy = -std::sin(theta);
    double pvz = -std::cos(theta) * std::cos(phi);

    int w = heightMap().width();
    int h = heightMap().height();
    int i = (int)(u * w);
    int j = (int)(v * h);
    if (i >= w) i = w - 1;
    if (j >= h) j = h - 1;
    int i2 = i + 1;
    if (i2 == w) i2 = 0;
    int j2 = j + 1;
    if (j2 == h) j2 = h - 1;

    double here = heightMap().at(i, j);
    double bu = heightMap().at(i2, j) - here;
    double bv = heightMap().at(i, j2) - here;

    // n' = n - bu pu - bv pv
    nx = n.x - bu * pux - bv * pvx;
    ny = n.y - bu * puy - bv * pvy;
    nz = n.z - bu * puz - bv * pvz;
    double len = std::sqrt(nx * nx + ny * ny + nz * nz);
    return Vector3(nx / len, ny / len, nz / len);
    // TASK T1 end
}

}  // namespace raytracer
