// T1
#include <raytracer/geometry/BumpySphere.h>
#include <cmath>
#include <algorithm>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 n = (position - centre()) / radius();
    n = n.normalised();

    double u = 0.5 + std::atan2(n.x, -n.z) / (2 * M_PI);
    double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / M_PI;

    // Pu is horizontal and points to the right. It stands at a right angle to n,
    // so swap x and z of n:
    double ring = std::sqrt(n.x * n.x + n.z * n.z);
    Vector3 Pu(1, 0, 0);
    if (ring > 0) Pu = Vector3(std::abs(n.z) / ring, 0, n.x / ring);
    // Pv points down
    Vector3 Pv = n.cross(Pu).normalised();
    if (Pv.y > 0) Pv = -Pv;

    int W = heightMap().width(), H = heightMap().height();
    int i = std::min((int)(u * W), W - 1);
    int j = std::min((int)(v * H), H - 1);
    double Bu = heightMap().at((i + 1) % W, j) - heightMap().at(i, j);
    double Bv = (j < H - 1) ? heightMap().at(i, j + 1) - heightMap().at(i, j) : 0;

    return (n - Bu * Pu - Bv * Pv).normalised();
    // TASK T1 end
}

}
