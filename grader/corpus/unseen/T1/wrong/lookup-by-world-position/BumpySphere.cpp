// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const double pi = std::numbers::pi;
    const Vector3 n = Sphere::getNormalAt(position);
    const Vector3 p = position.normalised();

    double u = 0.5 + std::atan2(p.x, -p.z) / (2 * pi);
    double v = std::acos(std::clamp(p.y, -1.0, 1.0)) / pi;

    int W = heightMap().width();
    int H = heightMap().height();
    int i = std::clamp(static_cast<int>(std::floor(u * W)), 0, W - 1);
    int j = std::clamp(static_cast<int>(std::floor(v * H)), 0, H - 1);
    double bu = heightMap().at((i + 1) % W, j) - heightMap().at(i, j);
    double bv = heightMap().at(i, std::min(j + 1, H - 1)) - heightMap().at(i, j);

    Vector3 pu = n.cross(Vector3(0, 1, 0)).normalised();
    Vector3 pv = n.cross(pu).normalised();
    if (std::abs(n.y) > 0.999999) return n;
    return (n + bu * n.cross(pv) - bv * n.cross(pu)).normalised();
    // TASK T1 end
}

}  // namespace raytracer
